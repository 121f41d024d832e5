#pragma once  // internal to ui/widgets

// How a person moves a slider: which movements belong together as one step of undo.

namespace cutis {

// What a key or a notch moves the value by, and the part of it that they and a drag move with
// shift.
inline constexpr double kSliderStep = 0.05;
inline constexpr double kFineStep = 0.1;

enum class SliderMotion {
  dragging,  // the mouse holds the handle
  stepping,  // a key or a notch of the wheel, to which the next one may belong
  done,      // the end of a drag, or a value chosen at once
};

}  // namespace cutis
