#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "kind.hpp"
#include "number_kinds.hpp"

namespace skylut::cli {

/// Several values of one kind, separated by commas, at least one and each once.
template <class T>
Kind<std::vector<T>> choice_list(Kind<T> one) {
  return {"LIST",
          [one](const std::string& text) {
            std::vector<T> values;
            for (const std::string& part : parts_of(text, ',')) {
              const T value = one.read(part);
              if (std::find(values.begin(), values.end(), value) != values.end())
                throw InputError("must have {} once, not twice", one.write(value));
              values.push_back(value);
            }
            return values;
          },
          [one](const std::vector<T>& values) { return joined(values, one.write); }};
}

}  // namespace skylut::cli
