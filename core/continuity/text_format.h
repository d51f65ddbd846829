// Numbers and orders as a person reads them in reports; private to this floor.
#pragma once

#include <string>
#include <string_view>

namespace osculate {

/// printf into a string; C++20's std::format is not in the compilers of Debian 12.
__attribute__((format(printf, 1, 2))) std::string format(const char* pattern, ...);

/// The unit of an order's residual, with a space before it; empty where it has none.
std::string_view unitOf(int order);
/// A residual with three digits and its unit.
std::string amount(double value, int order);
/// "G2", or "gap" below G0.
std::string orderName(int order);

/// "gap of 0.1 mm (tolerance 0.001 mm)", "G1, misses G2 by 0.2 (tolerance 0.01)", ...; `residual`
/// and `tolerance` of the order after `order`, which failed.
std::string missText(int order, double residual, double tolerance);

}  // namespace osculate
