#pragma once

// Colours and sizes of all plots. It has a ground of its own, so that it reads the same
// on a light and on a dark page.

#include "src/report/drawing.h"

namespace cutis::plot_style {

inline constexpr char kGround[] = "#ffffff";
inline constexpr char kInk[] = "#1f2328";
inline constexpr char kMuted[] = "#59636e";
inline constexpr char kGridColor[] = "#e3e7eb";
inline constexpr char kFrameColor[] = "#aab2bb";
// Apart in hue and in lightness, for readers who do not tell all hues.
inline constexpr char kRefined[] = "#c2410c";
inline constexpr char kNetwork[] = "#8b2fa0";
inline constexpr char kSearch[] = "#5b6672";
inline constexpr char kPaper[] = "#1f4e9c";
inline constexpr char kBound[] = "#14804a";

inline constexpr Stroke kGrid = {kGridColor, 1.0, ""};
inline constexpr Stroke kFrame = {kFrameColor, 1.0, ""};
inline constexpr Stroke kNoStroke = {"none", 0.0, ""};

inline constexpr TextStyle kHeading = {15.0, kInk, true};
inline constexpr TextStyle kSubheading = {12.5, kInk, true};
inline constexpr TextStyle kLabel = {12.0, kInk, false};
inline constexpr TextStyle kTick = {11.5, kMuted, false};
inline constexpr TextStyle kNote = {10.5, kMuted, false};

}  // namespace cutis::plot_style
