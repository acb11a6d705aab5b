#pragma once

// What another language could call.
extern "C" double zenith_luminance_cd_m2(const char* profiles_folder);
