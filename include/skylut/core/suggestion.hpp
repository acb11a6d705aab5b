#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Words that were misspelt.
namespace skylut {

/// The word that was probably meant: one that begins with the text or contains it, or that few typing errors
/// turn into it. Empty if none is near.
std::string nearest(std::string_view text, const std::vector<std::string>& words);

/// ", did you mean WORD?" or nothing.
std::string suggested(std::string_view text, const std::vector<std::string>& words);

/// "a, b or c".
std::string listed(const std::vector<std::string>& words);

}  // namespace skylut
