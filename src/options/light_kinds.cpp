#include "light_kinds.hpp"

#include "number_kinds.hpp"
#include "skylut/site/place.hpp"

namespace skylut::cli {

namespace {

double read_named(const char* what, const std::string& text, const Range& range) {
  try {
    return read_number(text, range);
  } catch (const InputError& error) {
    throw InputError("{} '{}': {}", what, text, error.what());
  }
}

// "Z:A"
Direction read_pair(const std::string& text, const Range& zenith) {
  const std::vector<std::string> angles = parts_of(text, ':');
  if (angles.size() != 2) throw InputError("'{}' must be ZENITH:AZIMUTH in degrees, for example 45:90", text);
  return {read_named("zenith angle", angles[0], zenith),
          read_named("azimuth", angles[1], domain::kAzimuth_deg)};
}

std::string written_pair(double zenith_deg, double azimuth_deg) {
  return fmt::format("{}:{}", zenith_deg, azimuth_deg);
}

// The library's own parsers name the text; the option names it, too.
template <class Parse>
auto without_prefix(const std::string& prefix, Parse parse) {
  try {
    return parse();
  } catch (const InputError& error) {
    const std::string message = error.what();
    throw InputError(message.starts_with(prefix) ? message.substr(prefix.size()) : message);
  }
}

std::string written_day(const UtcTime& time) {
  return fmt::format("{:04}-{:02}-{:02}", time.year, time.month, time.day);
}

}  // namespace

Kind<double> azimuth() {
  return {
      "NUMBER",
      [](const std::string& text) { return wrapped_azimuth_deg(read_number(text, domain::kAzimuth_deg)); },
      written};
}

Kind<std::vector<Direction>> suns() {
  const auto read = [](const std::string& text) {
    std::vector<Direction> suns;
    for (const std::string& part : parts_of(text, ',')) {
      const Direction sun = read_pair(part, domain::kSunZenith_deg);
      suns.push_back({sun.zenith_deg, wrapped_azimuth_deg(sun.azimuth_deg)});
    }
    return suns;
  };
  return {"Z:A,...", read, [](const std::vector<Direction>& suns) {
            return joined(suns,
                          [](const Direction& sun) { return written_pair(sun.zenith_deg, sun.azimuth_deg); });
          }};
}

Kind<std::vector<RelativeView>> relative_views() {
  const auto read = [](const std::string& text) {
    std::vector<RelativeView> views;
    for (const std::string& part : parts_of(text, ',')) {
      const Direction view = read_pair(part, domain::kAnyZenith_deg);
      views.push_back({view.zenith_deg, folded_relative_azimuth_deg(view.azimuth_deg, 0.0)});
    }
    return views;
  };
  return {"Z:A,...", read, [](const std::vector<RelativeView>& views) {
            return joined(views, [](const RelativeView& view) {
              return written_pair(view.zenith_deg, view.relative_azimuth_deg);
            });
          }};
}

Kind<double> latitude() {
  return {"ANGLE",
          [](const std::string& text) {
            return without_prefix(fmt::format("latitude '{}': ", text),
                                  [&] { return parse_place(text, "0", 0.0).latitude_deg; });
          },
          written};
}

Kind<double> longitude() {
  return {"ANGLE",
          [](const std::string& text) {
            return without_prefix(fmt::format("longitude '{}': ", text),
                                  [&] { return parse_place("0", text, 0.0).longitude_deg; });
          },
          written};
}

Kind<UtcTime> time_of_day() {
  return {"TIME",
          [](const std::string& text) {
            return without_prefix(fmt::format("time '{}': ", text), [&] { return parse_time(text); });
          },
          format_time};
}

Kind<UtcTime> day() {
  return {"DATE",
          [](const std::string& text) {
            return without_prefix(fmt::format("date '{}': ", text), [&] { return parse_date(text); });
          },
          written_day};
}

Kind<TimeSteps> time_steps() {
  return {"START/END/STEP",
          [](const std::string& text) {
            return without_prefix(fmt::format("times '{}': ", text), [&] { return parse_time_steps(text); });
          },
          format_time_steps};
}

Kind<TimeOrSteps> one_time() {
  const Kind<UtcTime> one = time_of_day();
  return {one.placeholder, [one](const std::string& text) -> TimeOrSteps { return one.read(text); },
          [one](const TimeOrSteps& time) { return one.write(std::get<UtcTime>(time)); }};
}

Kind<TimeOrSteps> time_or_steps() {
  const Kind<UtcTime> one = time_of_day();
  const Kind<TimeSteps> steps = time_steps();
  const auto read = [one, steps](const std::string& text) -> TimeOrSteps {
    if (text.find('/') == std::string::npos) return one.read(text);
    return steps.read(text);
  };
  return {one.placeholder + "|" + steps.placeholder, read, [one, steps](const TimeOrSteps& time) {
            const auto* const moment = std::get_if<UtcTime>(&time);
            return moment != nullptr ? one.write(*moment) : steps.write(std::get<TimeSteps>(time));
          }};
}

Kind<std::string> albedo() {
  const auto read = [](const std::string& text) {
    if (text.empty()) throw InputError("must be a number, a name or a file");
    const bool is_number = text.find_first_not_of("+-.eE0123456789 ") == std::string::npos;
    return is_number ? written(read_number(text, domain::kAlbedo)) : text;
  };
  return {"NUMBER|NAME|FILE", read, [](const std::string& text) { return text; }};
}

Kind<WavelengthGrid> wavelengths() {
  const auto read = [](const std::string& text) {
    std::string plain;
    for (const std::string& part : parts_of(text, ':'))
      plain += (plain.empty() ? "" : ":") + (part.starts_with('+') ? part.substr(1) : part);
    return without_prefix(fmt::format("wavelengths '{}': ", plain),
                          [&] { return WavelengthGrid::parse(plain); });
  };
  return {"LO:HI:STEP", read, [](const WavelengthGrid& grid) {
            return fmt::format("{}:{}:{}", grid.first_nm(), grid.last_nm(), grid.step_nm());
          }};
}

Kind<std::complex<double>> refractive_index() {
  const auto read = [](const std::string& text) -> std::complex<double> {
    const std::vector<std::string> parts = parts_of(text, ',');
    if (parts.size() != 2) throw InputError("must be RE,IM, for example 1.5,0.01 (IM > 0: absorbing)");
    return {read_named("real part", parts[0], {0.05, 20.0, ""}),
            read_named("imaginary part", parts[1], {0.0, 20.0, ""})};
  };
  return {"RE,IM", read,
          [](const std::complex<double>& index) { return fmt::format("{},{}", index.real(), index.imag()); }};
}

}  // namespace skylut::cli
