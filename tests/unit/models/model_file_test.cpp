#include "skylut/models/model_file.hpp"

#include <gtest/gtest.h>

#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

TEST(ModelFile, StatesItsDomainAndWhatItIs) {
  ModelFile file;
  file.form = "perez";
  file.error["rms"] = 0.5;
  file.model["A"] = 1.0;
  file.info.altitude_km = {0.0, 30.0, "km"};
  file.info.albedo = {0.0, 1.0, ""};
  const auto json = nlohmann::ordered_json::parse(model_file_json(file, Provenance("skylut fit")));
  EXPECT_EQ(json.begin().key(), "format");
  EXPECT_EQ(json["form"], "perez");
  EXPECT_EQ(json["command"], "skylut fit");
  EXPECT_EQ(json["domain"]["altitude_km"], (nlohmann::ordered_json{0.0, 30.0}));
  EXPECT_EQ(json["domain"]["albedo"], (nlohmann::ordered_json{0.0, 1.0}));
  EXPECT_EQ(json["error"]["rms"], 0.5);
  file.info.albedo.reset();
  EXPECT_FALSE(
      nlohmann::ordered_json::parse(model_file_json(file, Provenance()))["domain"].contains("albedo"));
}

}  // namespace
}  // namespace skylut
