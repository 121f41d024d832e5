#pragma once

// The standard error for our own words alone: what libraries print there by themselves is for their
// developers, and comes beside the sentence that we make of it.
//
// Thread-safe.

#include <string_view>

namespace cutis {

// While one of these lives, in whatever thread, what libraries print on the standard error goes
// nowhere. Builds with sanitizers, which report there, keep it.
class LibrarySilence {
 public:
  LibrarySilence();
  ~LibrarySilence();
  LibrarySilence(const LibrarySilence&) = delete;
  LibrarySilence& operator=(const LibrarySilence&) = delete;
};

// Writes the text to the standard error as it was when the program began. Allocates nothing.
void writeError(std::string_view text);

// Opens what is closed of the three standard streams, so that no file takes the place of one and
// receives what is printed there. First thing in main.
void keepStandardStreams();

}  // namespace cutis
