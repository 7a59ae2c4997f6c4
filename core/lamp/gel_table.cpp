#include "core/lamp/gel.h"

#include <cmath>

#include "core/color/chromaticity.h"
#include "core/color/srgb.h"

namespace swaplight {
namespace {

/// Mired shift as the maker states it; transmission rounded to a few per cent.
Gel correction(const char* id, const char* name, float miredShift, float transmission) {
  return {id, name, Gel::Kind::Correction, miredShift, 0, transmission, Rgb(1), Gel::Source::Maker};
}

/// The makers state CC values: CC30 is full, CC15 a half, CC075 a quarter, CC035 an eighth.
Gel green(const char* id, const char* name, float amount, float transmission) {
  return {id, name, Gel::Kind::Correction, 0, amount, transmission, Rgb(1), Gel::Source::Maker};
}

Gel neutral(const char* id, const char* name, float density) {
  return {id, name, Gel::Kind::Neutral, 0, 0, std::pow(10.0f, -density), Rgb(1), Gel::Source::Maker};
}

/// Made by eye.
Gel color(const char* id, const char* name, const Rgb& filter) {
  return {id, name, Gel::Kind::Color, 0, 0, luminance(filter), filter, Gel::Source::ByEye};
}

/// Codes of sRGB that the dissertation gives the gels of its experiments, over daylight (Lindsay 2013, 6.4).
Gel published(const char* id, const char* name, const Rgb& codes) {
  const Rgb filter = linearFromSrgb(codes / 255.0F);
  return {id, name, Gel::Kind::Color, 0, 0, luminance(filter), filter, Gel::Source::Published};
}

}  // namespace

const char* sourceName(Gel::Source source) {
  switch (source) {
    case Gel::Source::ByEye:
      return "by eye";
    case Gel::Source::Maker:
      return "maker";
    case Gel::Source::Published:
      return "published";
    case Gel::Source::Table:
      return "own table";
    case Gel::Source::Measured:
      return "measured";
  }
  return "";
}

const std::vector<Gel>& builtInGels() {
  static const std::vector<Gel> gels{
      correction("L200", "Double CT Blue", -274, 0.16f),
      correction("L201", "Full CT Blue", -137, 0.34f),
      correction("L281", "Three-quarter CT Blue", -113, 0.45f),
      correction("L202", "Half CT Blue", -78, 0.55f),
      correction("L203", "Quarter CT Blue", -35, 0.69f),
      correction("L218", "Eighth CT Blue", -18, 0.81f),
      correction("L204", "Full CT Orange", 159, 0.55f),
      correction("L285", "Three-quarter CT Orange", 124, 0.61f),
      correction("L205", "Half CT Orange", 109, 0.71f),
      correction("L206", "Quarter CT Orange", 64, 0.79f),
      correction("L223", "Eighth CT Orange", 26, 0.85f),
      green("L244", "Plus Green", 1, 0.74f),
      green("L245", "Half Plus Green", 0.5f, 0.83f),
      green("L246", "Quarter Plus Green", 0.25f, 0.88f),
      green("L278", "Eighth Plus Green", 0.125f, 0.90f),
      green("L247", "Minus Green", -1, 0.58f),
      green("L248", "Half Minus Green", -0.5f, 0.71f),
      green("L249", "Quarter Minus Green", -0.25f, 0.82f),
      green("L279", "Eighth Minus Green", -0.125f, 0.87f),
      neutral("L298", "0.15 Neutral Density", 0.15f),
      neutral("L209", "0.3 Neutral Density", 0.3f),
      neutral("L210", "0.6 Neutral Density", 0.6f),
      neutral("L211", "0.9 Neutral Density", 0.9f),
      neutral("L299", "1.2 Neutral Density", 1.2f),
      correction("R3202", "Full Blue", -131, 0.36f),
      correction("R3203", "Three-quarter Blue", -100, 0.41f),
      correction("R3204", "Half Blue", -68, 0.52f),
      correction("R3206", "Third Blue", -49, 0.64f),
      correction("R3208", "Quarter Blue", -30, 0.74f),
      correction("R3216", "Eighth Blue", -12, 0.81f),
      correction("R3407", "Sun CTO", 167, 0.47f),
      correction("R3411", "Sun Three-quarter CTO", 130, 0.58f),
      correction("R3401", "Sun 85", 131, 0.58f),
      correction("R3408", "Sun Half CTO", 81, 0.73f),
      correction("R3409", "Sun Quarter CTO", 42, 0.81f),
      correction("R3410", "Sun Eighth CTO", 20, 0.92f),
      green("R3304", "Plusgreen", 1, 0.76f),
      green("R3315", "Half Plusgreen", 0.5f, 0.90f),
      green("R3316", "Quarter Plusgreen", 0.25f, 0.92f),
      green("R3308", "Minusgreen", -1, 0.55f),
      green("R3313", "Half Minusgreen", -0.5f, 0.71f),
      green("R3314", "Quarter Minusgreen", -0.25f, 0.81f),
      neutral("R3415", "0.15 Neutral Density", 0.15f),
      neutral("R3402", "0.3 Neutral Density", 0.3f),
      neutral("R3403", "0.6 Neutral Density", 0.6f),
      neutral("R3404", "0.9 Neutral Density", 0.9f),
      color("L101", "Yellow", {0.95f, 0.80f, 0.08f}),
      color("L103", "Straw", {0.95f, 0.86f, 0.65f}),
      color("L104", "Deep Amber", {0.95f, 0.58f, 0.06f}),
      color("L105", "Orange", {0.95f, 0.32f, 0.03f}),
      color("L106", "Primary Red", {0.60f, 0.01f, 0.02f}),
      color("L113", "Magenta", {0.62f, 0.02f, 0.16f}),
      color("L115", "Peacock Blue", {0.05f, 0.52f, 0.55f}),
      color("L116", "Medium Blue-Green", {0.02f, 0.34f, 0.38f}),
      color("L119", "Dark Blue", {0.01f, 0.03f, 0.42f}),
      color("L120", "Deep Blue", {0.01f, 0.015f, 0.30f}),
      color("L124", "Dark Green", {0.03f, 0.40f, 0.12f}),
      color("L126", "Mauve", {0.35f, 0.01f, 0.32f}),
      color("L132", "Medium Blue", {0.02f, 0.14f, 0.60f}),
      color("L135", "Deep Golden Amber", {0.95f, 0.20f, 0.02f}),
      color("L139", "Primary Green", {0.02f, 0.22f, 0.03f}),
      color("L147", "Apricot", {0.95f, 0.42f, 0.16f}),
      color("L152", "Pale Gold", {0.95f, 0.75f, 0.60f}),
      color("L161", "Slate Blue", {0.12f, 0.35f, 0.75f}),
      color("L164", "Flame Red", {0.75f, 0.04f, 0.02f}),
      color("L181", "Congo Blue", {0.06f, 0.002f, 0.26f}),
      color("R02", "Bastard Amber", {0.95f, 0.72f, 0.55f}),
      color("R27", "Medium Red", {0.45f, 0.005f, 0.01f}),
      color("R80", "Primary Blue", {0.02f, 0.07f, 0.50f}),
      color("R90", "Dark Yellow Green", {0.03f, 0.20f, 0.04f}),
      published("R12", "Straw", {255, 203, 0}),
      published("R59", "Indigo", {0, 38, 96}),
      published("R89", "Moss Green", {42, 165, 95}),
      published("R4660", "60 Red", {218, 131, 102}),
  };
  return gels;
}

}  // namespace swaplight
