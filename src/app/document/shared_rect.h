#pragma once  // internal to src/app/document

#include <mutex>

#include "core/base/rect.h"

namespace cutis {

// A rectangle that one thread moves and others read.
class SharedRect {
 public:
  void set(const Rect& rect) {
    const std::lock_guard lock(mutex_);
    rect_ = rect;
  }
  Rect get() const {
    const std::lock_guard lock(mutex_);
    return rect_;
  }

 private:
  mutable std::mutex mutex_;
  Rect rect_;
};

}  // namespace cutis
