#include "skylut/export/sky_csv_reader.hpp"

#include "skylut/core/csv.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

SkyCsv read_sky_csv(const std::filesystem::path& path) {
  const CsvTable csv = CsvTable::read(path);
  const std::size_t zenith = csv.column("zenith_deg");
  const auto azimuth = csv.find_column("azimuth_deg");
  const auto gamma = csv.find_column("gamma_deg");
  if (!azimuth && !gamma)
    throw InputError("{}: neither column 'azimuth_deg' nor 'gamma_deg': the header must name one of them",
                     path.string());
  const auto luminance = csv.find_column("Y_cd_m2");
  const std::size_t Y = luminance ? *luminance : csv.column("Y");
  const std::size_t x = csv.column("x");
  const std::size_t y = csv.column("y");
  if (csv.rows() == 0) throw InputError("{}: holds no rows: must have at least one", path.string());

  const auto angle = [&csv](std::size_t row, std::size_t column, double highest) {
    const double value = csv.number(row, column);
    if (!(value >= 0.0 && value <= highest))
      throw InputError("{}: {} {}: must lie within 0-{}", csv.place(row), csv.columns()[column], value,
                       highest);
    return value;
  };
  SkyCsv sky;
  sky.sun_zenith_deg = csv.comment_number("sun_zenith_deg");
  sky.sun_azimuth_deg = csv.comment_number("sun_azimuth_deg");
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    SkyCsvRow read;
    read.zenith_deg = angle(row, zenith, 90.0);
    if (azimuth) read.azimuth_deg = csv.number(row, *azimuth);
    if (gamma) read.gamma_deg = angle(row, *gamma, 180.0);
    read.colour = {csv.number(row, Y), csv.number(row, x), csv.number(row, y)};
    if (!(read.colour.Y > 0.0))
      throw InputError("{}: {} {}: must be greater than 0", csv.place(row), csv.columns()[Y], read.colour.Y);
    read.line = csv.line(row);
    sky.rows.push_back(read);
  }
  return sky;
}

}  // namespace skylut
