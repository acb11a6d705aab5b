#include "skylut/core/suggestion.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

namespace skylut {

namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& character : result)
    character = static_cast<char>(std::tolower(static_cast<unsigned char>(character)));
  return result;
}

// Letters to insert, delete, replace or swap with the next to make one word the other (Damerau 1964,
// doi:10.1145/363958.363994; no letter is touched twice).
std::size_t typing_errors(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last;
  std::vector<std::size_t> last(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::vector<std::size_t> row(b.size() + 1, i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1), row[j - 1] + 1, last[j] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = std::exchange(last, std::move(row));
  }
  return last.back();
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
