#pragma once

// What a command line that is refused must look like.

#include <string>

#include <QtTest>

#include "tests/src/cli/program_run.h"

// One error that holds `part`, the exit status, and nothing on the standard output.
#define EXPECT_REFUSED(outcome, wantedStatus, part)                       \
  do {                                                                    \
    const auto& refused_o = (outcome);                                    \
    const std::string refused_part = (part);                              \
    QVERIFY2(isOneError(refused_o.errors), refused_o.errors.c_str());     \
    QVERIFY2(refused_o.errors.find(refused_part) != std::string::npos,    \
             (refused_part + " is not in: " + refused_o.errors).c_str()); \
    QCOMPARE(refused_o.status, (wantedStatus));                           \
    QVERIFY2(refused_o.output.empty(), refused_o.output.c_str());         \
  } while (false)
