#pragma once  // internal to ui/docks

// How high the docks of a column at the side are. Pure arithmetic: no widget, no event.

#include <vector>

namespace cutis {

// One dock, or several behind each other. In device-independent pixels, with the tabs.
struct ColumnPlace {
  int height;     // now
  int wanted;     // that shows the whole panel
  bool growing;   // more height shows more, as in a plot
  int least = 0;  // below which what grows is of no use
};

// Heights with the same sum, from top to bottom. Where the room suffices each is as high as it
// wants, and the rest goes to those that grow, in proportion to what they have, or else to the
// last. Where it does not suffice none has more than it wants, the upper ones are filled first, and
// what grows gives way to the others down to its least.
std::vector<int> settledHeights(const std::vector<ColumnPlace>& places);

}  // namespace cutis
