# Wrong requests to `skylut sun`, `skylut profile case`, and about the sun and the ground in general.
skylut_refuses(sun_no_sun 2 "no sun: give --sun-zenith-deg" sun -o sun.csv)
skylut_refuses(sun_output_txt 2 "sun.txt.*csv or .json" sun -o sun.txt --sun-zenith-deg 45)
skylut_refuses(sun_output_folder_missing 2 "no such folder: missing" sun -o missing/sun.csv --sun-zenith-deg 45)
skylut_refuses(sun_output_full 1 "sun.csv: cannot write: No space left" sun -o sun.csv --sun-zenith-deg 45
  --wavelengths-nm 400:700:100 --no-diffuse LINK sun.csv=/dev/full)
skylut_refuses(sun_zenith_181 2 "--sun-zenith-deg '181'.*0 to 180" sun --sun-zenith-deg 181)
skylut_refuses(sun_at_night 2 "--sun-zenith-deg 100: the sun is 100.00 deg from the zenith: diffuse light ends at 99 deg .night.: use --no-diffuse" sun -o sun.csv
  --sun-zenith-deg 100)
skylut_refuses(sun_altitude_31 2 "--altitude-km '31'.*0 to 30" sun --sun-zenith-deg 45 --altitude-km 31)
skylut_refuses(sun_twice 2 "--time.*must not be given with --sun-zenith-deg" sun --sun-zenith-deg 45 --latitude 48
  --longitude 2 --time 2024-06-21T09:00Z)
skylut_refuses(sun_date_twice 2 "--time.*must not be given with --date" sun --latitude 48 --longitude 2
  --time 2024-06-21T09:00Z --date 2024-06-21)
skylut_refuses(sun_turbidity_kind_alone 2 "--turbidity-kind: needs --turbidity" sun --sun-zenith-deg 45
  --turbidity-kind aod550)
skylut_refuses(sun_circumsolar_20 2 "--circumsolar-deg '20'.*0 to 10" sun --sun-zenith-deg 45 --circumsolar-deg 20)
skylut_refuses(sun_model_unknown 2 "--model 'bird'.*shells, iqbal or smarts-like" sun --sun-zenith-deg 45 --model bird)
skylut_refuses(sun_model_set 2 "--sun-zenith-deg 91: .*closed forms end at the horizon, 90 deg" sun --sun-zenith-deg 91
  --model iqbal)
skylut_refuses(sun_model_circumsolar 2 "--circumsolar-deg 3.*must not be given" sun --sun-zenith-deg 45 --model iqbal
  --circumsolar-deg 3)
skylut_refuses(sun_tilt_181 2 "--tilt-deg '181'.*0 to 180" sun --sun-zenith-deg 45 --tilt-deg 181)
skylut_refuses(sun_tilt_azimuth_alone 2 "--tilt-azimuth-deg: needs --tilt-deg" sun --sun-zenith-deg 45 --tilt-azimuth-deg 90)
skylut_refuses(sun_model_tilt 2 "--tilt-deg 30: --model iqbal has no diffuse light, must not be given" sun --sun-zenith-deg 45
  --model iqbal --tilt-deg 30)

skylut_refuses(solar_unknown 2 "solar spectrum 'sun'.*astm-g173, gueymard2003, kurucz1992" map -o sky.csv
  --sun-zenith-deg 45 --solar sun)
skylut_refuses(solar_too_short 2 "must lie within 359.5-830.5 nm of the solar spectrum" map -o sky.csv
  --sun-zenith-deg 45 --solar kurucz1992 --wavelengths-nm 350:700:50 --quality draft)
skylut_refuses(solar_file_missing 2 "mine.csv: cannot read" sun --sun-zenith-deg 45 --solar mine.csv)
skylut_refuses(solar_file_column 2 "mine.csv.*irradiance_W_m2_nm" sun --sun-zenith-deg 45 --solar mine.csv
  INPUT "mine.csv=wavelength_nm,irradiance\\n300,1\\n1000,1\\n")
skylut_refuses(solar_file_unit 2 "mine.csv:3: irradiance_W_m2_nm 1850" sun --sun-zenith-deg 45 --solar mine.csv
  INPUT "mine.csv=wavelength_nm,irradiance_W_m2_nm\\n300,1\\n550,1850\\n")
skylut_refuses(date_word 2 "--date 'today': must be a day" map -o sky.csv --sun-zenith-deg 45 --date today)
skylut_refuses(date_no_such_day 2 "--date '2024-02-30': must be a day" table --out out --date 2024-02-30)

skylut_refuses(albedo_unknown 2 "albedo 'gras'.*asphalt, grass, sand, snow, water" map -o sky.csv
  --sun-zenith-deg 45 --albedo gras)
skylut_refuses(albedo_file_line 2 "mine.csv:3: albedo 1.5" map -o sky.csv --sun-zenith-deg 45 --albedo mine.csv
  INPUT "mine.csv=wavelength_nm,albedo\\n300,0.1\\n1000,1.5\\n")
skylut_refuses(albedo_file_short 2 "ground albedo mine.csv: has no value at 380 nm" map -o sky.csv --sun-zenith-deg 45
  --albedo mine.csv INPUT "mine.csv=wavelength_nm,albedo\\n400,0.1\\n700,0.5\\n")

skylut_refuses(case_no_wavelength 2 "--wavelength-nm is required" profile case ussa1976 -o case.json)
skylut_refuses(case_wavelength_1100 2 "--wavelength-nm '1100'.*300 to 1000" profile case ussa1976 -o case.json
  --wavelength-nm 1100)
skylut_refuses(case_profile_unknown 2 "profile 'mars'" profile case mars -o case.json --wavelength-nm 550)
skylut_refuses(case_view_broken 2 "--view '60': '60' must be ZENITH:AZIMUTH" profile case ussa1976 -o case.json --wavelength-nm 550
  --view 60)
skylut_refuses(case_term_99999 2 "--absorption-term 99999" profile case ussa1976 -o case.json --wavelength-nm 550
  --absorption-term 99999)
skylut_refuses(case_output_folder_missing 2 "no such folder: missing" profile case ussa1976 -o missing/case.json
  --wavelength-nm 550)
skylut_prints(sun_to_the_screen "direct normal.*W/m2.*lux" sun --sun-zenith-deg 30 --no-diffuse)
skylut_prints(sun_hidden "the ground hides the sun" sun --sun-zenith-deg 120 --no-diffuse)

# What is seldom meant is said, and done.
skylut_refuses(sun_at_midnight 2 "--time 2024-06-21T00:00:00Z: the sun is 1[0-9.]+ deg from the zenith: .*use --no-diffuse" sun
  --latitude 48 --longitude 2 --time 2024-06-21T00:00Z)
set(linke_warning "turbidity 3 .aod500. is an optical depth.*T 28.[0-9], visibility [0-9.]+ km.*--turbidity-kind preetham-t")
skylut_prints(sun_in_fog "direct normal" sun --sun-zenith-deg 30 --no-diffuse --turbidity 3 WARNS "${linke_warning}")
skylut_prints(profile_in_fog "aod500 +3" profile show ussa1976 --turbidity 3 WARNS "${linke_warning}")
skylut_prints(case_in_fog "spherical layers" profile case ussa1976 --wavelength-nm 550 --turbidity 3 WARNS "${linke_warning}")
skylut_prints(map_in_fog "wrote sky.csv" map -o sky.csv --sun-zenith-deg 30 --turbidity 3 --wavelengths-nm 400:700:100 --quality draft
  WARNS "${linke_warning}")
skylut_prints(table_in_fog "wrote out/table.csv" table --out out --altitudes-km 0 --suns 30:0 --turbidities 0,3
  --wavelengths-nm 400:700:100 --quality draft WARNS "${linke_warning}")
skylut_prints(sun_haze "direct normal" sun --sun-zenith-deg 30 --no-diffuse --turbidity 1.5)
skylut_prints(sun_in_fog_by_visibility "direct normal" sun --sun-zenith-deg 30 --no-diffuse --turbidity 1 --turbidity-kind visibility-km)
skylut_prints(map_of_one_wavelength "wrote sky.csv" map -o sky.csv --sun-zenith-deg 30 --wavelengths-nm 500:500:5 --quality draft
  WARNS "luminance and colour count only 497.5-502.5 nm: 1.5 % of the eye's sensitivity")
skylut_prints(sun_of_red_light "direct normal" sun --no-diffuse --sun-zenith-deg 30 --wavelengths-nm 600:780:5
  WARNS "luminance and colour count only 600-780 nm: 1[78] % of the eye's sensitivity")
skylut_refuses(sun_refraction_and_not 2 "--refraction: must not be given with --no-refraction" sun --sun-zenith-deg 45
  --refraction --no-refraction)
skylut_refuses(sun_apparent_at_a_time 2 "--apparent: says what --sun-zenith-deg is, needs it" sun --apparent
  --time 2024-06-21T12:00:00Z --latitude 48 --longitude 2)
