#include "ui/docks/dock_column.h"

#include <algorithm>

namespace cutis {
namespace {

// Divides `rest` among those that grow; what rounding leaves goes to the last of them.
void grow(const std::vector<ColumnPlace>& places, std::vector<int>& heights, int rest) {
  int growingHeight = 0;
  std::size_t last = places.size() - 1;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!places[k].growing) continue;
    growingHeight += places[k].height;
    last = k;
  }
  int given = 0;
  for (std::size_t k = 0; k < places.size() && growingHeight > 0; ++k) {
    if (!places[k].growing) continue;
    const int share = static_cast<int>(1.0 * rest * places[k].height / growingHeight);
    heights[k] += share;
    given += share;
  }
  heights[last] += rest - given;
}

// A list that is short can be scrolled; sliders that are out of sight are missed.
void giveWay(const std::vector<ColumnPlace>& places, std::vector<int>& heights) {
  for (std::size_t k = 0; k < places.size(); ++k) {
    for (std::size_t g = places.size(); g-- > 0 && !places[k].growing;) {
      const int spare = places[g].growing ? std::max(0, heights[g] - places[g].least) : 0;
      const int given = std::min(spare, places[k].wanted - heights[k]);
      heights[k] += given;
      heights[g] -= given;
    }
  }
}

}  // namespace

std::vector<int> settledHeights(const std::vector<ColumnPlace>& places) {
  std::vector<int> heights;
  int rest = 0;
  for (const ColumnPlace& place : places) {
    heights.push_back(std::min(place.height, place.wanted));
    rest += place.height - heights.back();
  }
  if (places.empty()) return heights;
  for (std::size_t k = 0; k < places.size() && rest > 0; ++k) {
    const int more = std::min(rest, places[k].wanted - heights[k]);
    heights[k] += more;
    rest -= more;
  }
  if (rest > 0) {
    grow(places, heights, rest);
  } else {
    giveWay(places, heights);
  }
  return heights;
}

}  // namespace cutis
