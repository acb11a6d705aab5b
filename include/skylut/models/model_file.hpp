#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "skylut/core/provenance.hpp"
#include "skylut/models/sky_model.hpp"

namespace skylut {

/// What a model file holds beside its provenance. `skylut fit --form` writes such files, `skylut eval` and
/// whatever takes a model reads them.
struct ModelFile {
  std::string form;              ///< which formula: one of model_forms()
  ModelInfo info;                ///< its domain, as fitted
  nlohmann::ordered_json error;  ///< what the form says of its accuracy, measured
  nlohmann::ordered_json model;  ///< the form's own numbers
};

/// The text of a model file: {"format": "skylut model", "form", provenance, "domain", "error", "model"}. The
/// same model gives the same bytes.
std::string model_file_json(const ModelFile& file, const Provenance& provenance);

/// The model of a file that is not written yet: the same as reading it back.
std::unique_ptr<const SkyModel> make_model(const ModelFile& file);

/// Forms that can be read back.
std::vector<std::string> model_forms();

/// Whether the path is a file that says it is a model file, of whatever form.
bool is_model_file(const std::filesystem::path& path);

/// @throws InputError  "file: key: what is wrong, what would be right"
std::unique_ptr<const SkyModel> read_model_file(const std::filesystem::path& path);

}  // namespace skylut
