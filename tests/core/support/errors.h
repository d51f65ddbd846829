// Bad input, and checks of the message of an error.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace osculate::test {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Whether the statement throws std::invalid_argument with this text in its message.
template <class Statement>
testing::AssertionResult throwsError(Statement statement, const std::string& text) {
  try {
    statement();
  } catch (const std::invalid_argument& error) {
    if (std::string(error.what()).find(text) != std::string::npos)
      return testing::AssertionSuccess();
    return testing::AssertionFailure() << "the message is \"" << error.what() << "\"";
  }
  return testing::AssertionFailure() << "nothing was thrown";
}

}  // namespace osculate::test

/// The error must name the argument and the rule in these words.
#define EXPECT_ERROR(statement, text) \
  EXPECT_TRUE(osculate::test::throwsError([&] { static_cast<void>(statement); }, text))
