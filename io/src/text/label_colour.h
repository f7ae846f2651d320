#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dupin::text {

using Colour = std::array<std::uint8_t, 3>;  // sRGB

/// A colour to tell labels apart: hues a golden section of the circle apart, so that neighbours
/// differ and none returns.
inline Colour label_colour(std::size_t label) {
  constexpr double kGoldenSection = 0.6180339887498949;
  const double turns = std::fmod(0.58 + kGoldenSection * static_cast<double>(label), 1.0);
  Colour colour{};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    // A trapezoid wave over the hue circle, shifted by a third for each channel, in light tones.
    const double phase = std::fmod(6 * turns + 8 - 2 * static_cast<double>(channel), 6.0);
    const double wave = std::fmin(std::fmax(std::abs(phase - 3) - 1, 0.0), 1.0);
    colour[channel] = static_cast<std::uint8_t>(std::lround(120 + 120 * wave));
  }
  return colour;
}

/// "#RRGGBB"
inline std::string colour_code(const Colour& colour) {
  constexpr char kDigits[] = "0123456789ABCDEF";
  std::string code = "#";
  for (const std::uint8_t channel : colour) {
    code += kDigits[channel >> 4];
    code += kDigits[channel & 15];
  }
  return code;
}

/// The colour that "#rrggbb" says, digits in any case; none for other texts.
inline std::optional<Colour> colour_of_code(std::string_view code) {
  if (code.size() != 7 || code[0] != '#') {
    return std::nullopt;
  }
  Colour colour{};
  for (std::size_t i = 1; i < code.size(); ++i) {
    const char c = code[i];
    const int digit = c >= '0' && c <= '9'   ? c - '0'
                      : c >= 'a' && c <= 'f' ? c - 'a' + 10
                      : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                             : -1;
    if (digit < 0) {
      return std::nullopt;
    }
    std::uint8_t& channel = colour.at((i - 1) / 2);
    channel = static_cast<std::uint8_t>(channel * 16 + digit);
  }
  return colour;
}

/// What a label's name begins with, up to its first dot: the part that it is of.
inline std::string_view part_of_label(std::string_view label) {
  return label.substr(0, label.find('.'));
}

/// Of every label: what `chosen` says of its name, or of what this begins with up to some dot, or
/// else label_colour of its part, parts being counted in the order of their first labels.
inline std::vector<Colour> label_colours(const std::vector<std::string>& names,
                                         const std::map<std::string, std::string>& chosen) {
  std::map<std::string_view, std::size_t> parts;
  std::vector<Colour> colours;
  for (const std::string& name : names) {
    const auto part = parts.try_emplace(part_of_label(name), parts.size()).first;
    std::optional<Colour> colour;
    for (std::string_view stem = name; !colour && !chosen.empty();) {
      if (const auto found = chosen.find(std::string(stem)); found != chosen.end()) {
        colour = colour_of_code(found->second);
      }
      const std::size_t dot = stem.rfind('.');
      if (dot == std::string_view::npos) {
        break;
      }
      stem = stem.substr(0, dot);
    }
    colours.push_back(colour.value_or(label_colour(part->second)));
  }
  return colours;
}

}  // namespace dupin::text
