#include "skylut/core/suggestion.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace skylut {

namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& character : result)
    character = static_cast<char>(std::tolower(static_cast<unsigned char>(character)));
  return result;
}

// Letters to insert, delete or replace to make one word the other (Levenshtein 1966).
std::size_t typing_errors(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest(std::string_view text, const std::vector<std::string>& words) {
  constexpr std::size_t kLeastPart = 3;  // shorter parts are in many words
  const std::string wanted = lower(text);
  std::string best;
  std::size_t fewest = 2 + wanted.size() / 6;
  for (const std::string& word : words)
    if (const std::size_t errors = typing_errors(wanted, lower(word)); errors < fewest) {
      fewest = errors;
      best = word;
    }
  if (!best.empty() || wanted.size() < kLeastPart) return best;
  for (const std::string& word : words)
    if (word.starts_with(wanted)) return word;
  for (const std::string& word : words)
    if (word.find(wanted) != std::string::npos) return word;
  return {};
}

std::string suggested(std::string_view text, const std::vector<std::string>& words) {
  const std::string word = nearest(text, words);
  return word.empty() ? "" : ", did you mean " + word + "?";
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

}  // namespace skylut
