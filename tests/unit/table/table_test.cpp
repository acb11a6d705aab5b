#include "skylut/table/table.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "skylut/core/errors.hpp"
#include "skylut/table/table_csv.hpp"
#include "skylut/table/table_model.hpp"
#include "skylut/table/write_table.hpp"
#include "support/test_context.hpp"
#include "test_maps.hpp"

namespace skylut {
namespace {

namespace fs = std::filesystem;

class TableOnDisk : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    const std::vector<TableSky> skies{perez_table_sky(0.0, {60.0, 90.0}), perez_table_sky(12.0, {60.0, 90.0}),
                                      perez_table_sky(12.0, {45.0, 180.0})};
    fitted_ = fit_table(test::context, skies, TableFitOptions::half_floats());
    Provenance provenance("skylut table --suns 60:90,45:180");
    provenance.describe("turbidities",
                        {{{"given", 0.5}, {"kind", "aod550"}, {"aod550", 0.5}, {"preetham-t", 7.5}}});
    write_table(folder_, fitted_, provenance);
  }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const char* name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  std::string refusal(std::optional<TurbidityKind> kind = {}) {
    try {
      Table::read(folder_, kind);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  const fs::path folder_ = fs::temp_directory_path() / "skylut_table_test";
  SkyTable fitted_;
};

TEST_F(TableOnDisk, ComesBackWithAxesKindAndProvenance) {
  for (const fs::path& path : {folder_, folder_ / "table.csv"}) {
    const Table table = Table::read(path);
    EXPECT_EQ(table.entries(), fitted_.entries);
    EXPECT_EQ(table.axes().altitudes_km, (std::vector<double>{0.0, 12.0}));
    EXPECT_EQ(table.axes().turbidities, std::vector<double>{0.5});
    EXPECT_EQ(table.axes().suns, (std::vector<Direction>{{60.0, 90.0}, {45.0, 180.0}}));
    EXPECT_EQ(table.turbidity_kind(), TurbidityKind::aod550);
    ASSERT_TRUE(table.provenance());
    EXPECT_EQ(table.provenance()->command, "skylut table --suns 60:90,45:180");
    EXPECT_EQ(nlohmann::json::parse(table.provenance()->inputs)["turbidities"][0]["preetham-t"], 7.5);
  }
}

TEST_F(TableOnDisk, ConvertsTurbidityAsItsJsonDoes) {
  const Table table = Table::read(folder_);
  EXPECT_EQ(table.turbidities_as(test::context, TurbidityKind::preetham_t), std::vector<double>{7.5});
  EXPECT_EQ(table.turbidities_as(test::context, TurbidityKind::aod550), std::vector<double>{0.5});
  EXPECT_THROW(table.turbidities_as(test::context, TurbidityKind::aod500), InputError);  // not listed
}

TEST_F(TableOnDisk, TakesTurbiditiesOfOtherKindsAsItsJsonConvertsThem) {
  const Turbidity own = Table::read(folder_).in_own_kind(test::context, {TurbidityKind::preetham_t, 7.5});
  EXPECT_EQ(own.kind, TurbidityKind::aod550);
  EXPECT_EQ(own.value, 0.5);
  // One pair of numbers says nothing of others.
  EXPECT_THROW(Table::read(folder_).in_own_kind(test::context, {TurbidityKind::preetham_t, 6.0}), InputError);
}

// Every kind is proportional to optical depth but for a constant, the visibility inversely: T = 1 + 13 aod550
// and V = 3.912/(0.0115 + 0.4 aod550), straight on between and beyond the pairs of table.json.
TEST_F(TableOnDisk, ConvertsBetweenItsTurbidities) {
  std::vector<TableEntry> entries(2, fitted_.entries.front());
  entries[0].turbidity = 0.1;
  nlohmann::ordered_json listed;
  for (const TableEntry& entry : entries)
    listed.push_back({{"given", entry.turbidity},
                      {"kind", "aod550"},
                      {"preetham-t", 1.0 + 13.0 * entry.turbidity},
                      {"visibility-km", 3.912 / (0.0115 + 0.4 * entry.turbidity)}});
  write("table.csv", format_table_csv(entries));
  write("table.json", nlohmann::ordered_json{{"format", "skylut table"},
                                             {"skylut_version", "0.2.0"},
                                             {"command", "skylut table"},
                                             {"inputs", {{"turbidities", listed}}}}
                          .dump());
  const Table table = Table::read(folder_);
  for (const double aod550 : {0.0, 0.1, 0.3, 0.7}) {
    EXPECT_NEAR(table.in_own_kind(test::context, {TurbidityKind::preetham_t, 1.0 + 13.0 * aod550}).value,
                aod550, 1e-12);
    EXPECT_NEAR(
        table.in_own_kind(test::context, {TurbidityKind::visibility_km, 3.912 / (0.0115 + 0.4 * aod550)})
            .value,
        aod550, 1e-12);
  }
}

// Without table.json: the 1976 standard atmosphere and Ångström's exponent 1.3. By hand: aod550 is
// 0.5 (550/500)^-1.3 = 0.44173; Rayleigh's depth at sea level 0.0971 (Bodhaine et al. 1999), so T = 5.55.
TEST_F(TableOnDisk, ConvertsWithoutJsonInTheStandardAtmosphere) {
  fs::remove(folder_ / "table.json");
  const Table table = Table::read(folder_);
  EXPECT_FALSE(table.provenance());
  EXPECT_EQ(table.turbidity_kind(), TurbidityKind::aod500);
  const auto T = table.turbidities_as(test::context, TurbidityKind::preetham_t);
  EXPECT_NEAR(T[0], 1.0 + 0.44173 / 0.0971, 0.02);
  EXPECT_NEAR(
      Table::read(folder_, TurbidityKind::aod550).turbidities_as(test::context, TurbidityKind::preetham_t)[0],
      1.0 + 0.5 / 0.0971, 0.02);
}

TEST_F(TableOnDisk, RefusesAnotherTable) {
  auto changed = fitted_.entries;
  changed[1].Y.A += 1e-9;
  write("table.csv", format_table_csv(changed));
  EXPECT_NE(refusal().find("table.csv: sha256 "), std::string::npos);
  EXPECT_NE(refusal().find("table.json"), std::string::npos);
}

// The json is about table.csv, not about whatever lies beside it.
TEST_F(TableOnDisk, JsonOfAnotherFileIsLeftAside) {
  write("mine.csv", format_table_csv({fitted_.entries.data(), 1}));
  EXPECT_FALSE(Table::read(folder_ / "mine.csv").provenance());
}

TEST_F(TableOnDisk, RefusesAKindThatJsonContradicts) {
  EXPECT_EQ(refusal(TurbidityKind::aod550), "no error");
  EXPECT_NE(refusal(TurbidityKind::preetham_t).find("turbidity kind preetham-t: "), std::string::npos);
}

TEST_F(TableOnDisk, RefusesJsonOfSomethingElse) {
  write("table.json", "{\"format\": \"skylut fit\"}");
  EXPECT_NE(refusal().find("must be the table.json of skylut table"), std::string::npos);
}

TEST_F(TableOnDisk, TwoRowsOfOneKeyAreAmbiguous) {
  auto entries = fitted_.entries;
  entries.push_back(entries[1]);
  EXPECT_THROW(Table{entries}, InputError);
}

TEST_F(TableOnDisk, IsASkyModelAtItsRows) {
  const TableModel model(Table::read(folder_));
  EXPECT_EQ(model.info().altitude_km.highest, 12.0);
  EXPECT_EQ(model.info().turbidity_kind, TurbidityKind::aod550);
  SkyConditions conditions{
      .altitude_km = 12.0, .turbidity = {TurbidityKind::aod550, 0.5}, .sun = {45.0, 180.0}};
  const auto sky = model.at(conditions);
  EXPECT_NEAR(sky->colour(Direction{0.0, 0.0}).Y, 3500.0, 1e-9);  // cd/m²
  const SampledSky seen = perez_table_sky(12.0, {45.0, 180.0}).check;
  for (std::size_t i = 0; i < seen.views.size(); ++i) {
    const Direction view{seen.views[i].zenith_deg, 180.0 + seen.views[i].relative_azimuth_deg};
    EXPECT_NEAR(sky->colour(view).Y, seen.colour[i].Y, 1e-6 * seen.colour[i].Y);
  }

  conditions.altitude_km = 6.0;
  EXPECT_THROW(model.at(conditions), InputError);
  conditions.altitude_km = 0.0;  // both values are on the axes, the row is not there
  EXPECT_THROW(model.at(conditions), InputError);
  conditions.altitude_km = 12.0;
  conditions.turbidity.kind = TurbidityKind::aod500;
  EXPECT_THROW(model.at(conditions), InputError);
}

}  // namespace
}  // namespace skylut
