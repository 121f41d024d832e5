#pragma once

// Assertions that print the values that failed.

#include <cmath>
#include <string>

#include <QString>
#include <QtTest>

#include "core/base/result.h"

// |actual − expected| ≤ tolerance; NaN fails.
#define EXPECT_NEAR(actual, expected, tolerance)                                     \
  do {                                                                               \
    const double expect_a = (actual), expect_e = (expected), expect_t = (tolerance); \
    QVERIFY2(std::abs(expect_a - expect_e) <= expect_t,                              \
             qPrintable(QString("%1 is %2, expected %3 ± %4")                        \
                            .arg(#actual)                                            \
                            .arg(expect_a, 0, 'g', 10)                               \
                            .arg(expect_e, 0, 'g', 10)                               \
                            .arg(expect_t, 0, 'g', 3)));                             \
  } while (false)

// actual ≤ limit; NaN fails.
#define EXPECT_AT_MOST(actual, limit)                                           \
  do {                                                                          \
    const double expect_a = (actual), expect_l = (limit);                       \
    QVERIFY2(expect_a <= expect_l, qPrintable(QString("%1 is %2, allowed %3")   \
                                                  .arg(#actual)                 \
                                                  .arg(expect_a, 0, 'g', 10)    \
                                                  .arg(expect_l, 0, 'g', 10))); \
  } while (false)

// A Result or Status that must hold a value; prints its error otherwise.
#define EXPECT_OK(...)                                                                           \
  do {                                                                                           \
    const auto& expect_r = (__VA_ARGS__);                                                        \
    QVERIFY2(bool(expect_r), expect_r.failed() ? expect_r.error().text().c_str() : "cancelled"); \
  } while (false)

// A Result or Status that must have failed with an error whose text contains `part`.
#define EXPECT_ERROR(result, part)                                                    \
  do {                                                                                \
    const auto& expect_r = (result);                                                  \
    const std::string expect_p = (part);                                              \
    QVERIFY2(expect_r.failed(), ("expected an error with: " + expect_p).c_str());     \
    QVERIFY2(expect_r.error().text().find(expect_p) != std::string::npos,             \
             ("expected '" + expect_p + "' in: " + expect_r.error().text()).c_str()); \
  } while (false)
