#include "src/report/plot/theme.h"

namespace cutis {
namespace {

PlotTheme makePrintTheme() {
  PlotTheme theme;
  theme.ground = Color::rgb(0xffffff);
  theme.ink = Color::rgb(0x1f2328);
  theme.muted = Color::rgb(0x59636e);
  theme.grid = Color::rgb(0xe3e7eb);
  theme.frame = Color::rgb(0xaab2bb);
  theme.shade = Color::rgb(0xf1f4f7);
  theme.outerShade = theme.ground;
  theme.series = {Color::rgb(0xc2410c), Color::rgb(0x1f4e9c), Color::rgb(0x8b2fa0),
                  Color::rgb(0x5b6672), Color::rgb(0x14804a)};
  theme.heading = {15.0, theme.ink, true};
  theme.title = {12.5, theme.ink, true};
  theme.label = {12.0, theme.ink, false};
  theme.tick = {11.5, theme.muted, false};
  theme.note = {10.5, theme.muted, false};
  return theme;
}

}  // namespace

const PlotTheme& printTheme() {
  static const PlotTheme theme = makePrintTheme();
  return theme;
}

}  // namespace cutis
