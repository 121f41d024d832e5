#pragma once

// The files below resources/, compiled into the program by resources/embed.cpp. Read them through
// src/files/resources.h.

namespace cutis {

struct ResourceData {
  const char* name;  // path below resources/, e.g. "spectra/illuminants/cie_D65.csv"
  const unsigned char* bytes;
  unsigned long size;
};

extern const ResourceData kResourceData[];
extern const unsigned kResourceCount;

}  // namespace cutis
