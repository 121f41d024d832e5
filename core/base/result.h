#pragma once

// Errors as values.
//
// Every function that can fail for a reason outside this program (a file, an option, a full disk)
// returns a Result. A Result is one of three things: a value, an Error, or Cancelled. Being
// cancelled is not an error: nobody reports it, callers just unwind. Violated contracts between our
// own functions are assertions, never Results.

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace cutis {

// Who has to act. The command line turns it into the exit status.
enum class ErrorKind {
  usage,     // the command was wrong: unknown option, missing argument
  input,     // a file or a value in it was wrong
  resource,  // memory, disk, permission to write
};

struct Error {
  ErrorKind kind = ErrorKind::input;
  // Where: "face.exr", "rig.json:12:5", "--noise". May be empty.
  std::string place;
  // What is wrong, where in it; what to do. One sentence, no final full stop.
  std::string message;

  // "place: message"; of a long place the ends, see shortenedPlace().
  std::string text() const;
};

struct Cancelled {};

// The part of a Result that is not a value; converts into a Result of any type.
using Failure = std::variant<Error, Cancelled>;

template <typename T>
class Result;

// A Result without a value: `return {};` means done.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : failure_(std::in_place_index<1>, std::move(error)) {}
  Result(Cancelled) : failure_(std::in_place_index<2>) {}
  Result(Failure failure) : failure_(std::in_place_index<2>) {
    if (auto* error = std::get_if<Error>(&failure)) failure_.emplace<1>(std::move(*error));
  }

  explicit operator bool() const { return failure_.index() == 0; }
  bool failed() const { return failure_.index() == 1; }
  bool cancelled() const { return failure_.index() == 2; }
  const Error& error() const { return std::get<1>(failure_); }
  Failure failure() const {
    assert(failure_.index() != 0);
    if (failed()) return error();
    return Cancelled{};
  }

 private:
  std::variant<std::monostate, Error, Cancelled> failure_;
};

using Status = Result<void>;

// A value, or the Status that says why there is none. (Not one variant of all three: that is
// compiled anew for every type of value, which was a twentieth of a whole build.)
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : value_(std::in_place, std::move(value)) {}
  Result(Error error) : status_(std::move(error)) {}
  Result(Cancelled cancelled) : status_(cancelled) {}
  Result(Failure failure) : status_(std::move(failure)) {}

  explicit operator bool() const { return value_.has_value(); }
  bool failed() const { return status_.failed(); }
  bool cancelled() const { return status_.cancelled(); }

  // Precondition: holds a value.
  T& value() & { return *value_; }
  const T& value() const& { return *value_; }
  T&& value() && { return *std::move(value_); }

  // Precondition: failed().
  const Error& error() const { return status_.error(); }

  // Precondition: holds no value.
  Failure failure() const { return status_.failure(); }

 private:
  std::optional<T> value_;
  Status status_;
};

inline Error usageError(std::string place, std::string message) {
  return {ErrorKind::usage, std::move(place), std::move(message)};
}
inline Error inputError(std::string place, std::string message) {
  return {ErrorKind::input, std::move(place), std::move(message)};
}
inline Error resourceError(std::string place, std::string message) {
  return {ErrorKind::resource, std::move(place), std::move(message)};
}

}  // namespace cutis

// CUTIS_TRY(name, expression): evaluates a Result; on failure returns it from the enclosing
// function, otherwise binds its value to `name`.
#define CUTIS_TRY(name, ...)                          \
  auto name##_result = (__VA_ARGS__);                 \
  if (!name##_result) return name##_result.failure(); \
  auto& name = name##_result.value()

// CUTIS_CHECK(expression): the same for a Status.
#define CUTIS_CHECK(...)                              \
  do {                                                \
    auto CUTIS_UNIQUE(cutis_status_) = (__VA_ARGS__); \
    if (!CUTIS_UNIQUE(cutis_status_)) {               \
      return CUTIS_UNIQUE(cutis_status_).failure();   \
    }                                                 \
  } while (false)

// A name per line, so that a check may stand in a lambda inside another.
#define CUTIS_UNIQUE(prefix) CUTIS_JOIN(prefix, __LINE__)
#define CUTIS_JOIN(a, b) CUTIS_JOIN_AGAIN(a, b)
#define CUTIS_JOIN_AGAIN(a, b) a##b
