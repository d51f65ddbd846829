#include "osculate/continuity/text_format.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace osculate {

std::string format(const char* pattern, ...) {
  std::va_list arguments;
  va_start(arguments, pattern);
  char buffer[256];
  std::vsnprintf(buffer, sizeof buffer, pattern, arguments);
  va_end(arguments);
  return buffer;
}

std::string_view unitOf(int order) { return order == 0 ? " mm" : order == 1 ? " deg" : ""; }

std::string amount(double value, int order) {
  if (!std::isfinite(value)) return "no such derivative";
  return format("%.3g", value) + std::string(unitOf(order));
}

std::string orderName(int order) { return order < 0 ? "gap" : format("G%d", order); }

std::string missText(int order, double residual, double tolerance) {
  const int next = order + 1;
  const std::string limit = " (tolerance " + amount(tolerance, next) + ")";
  if (next == 0) return "gap of " + amount(residual, 0) + limit;
  const std::string name = orderName(order);
  if (!std::isfinite(residual))
    return name + ", " + orderName(next) + " does not exist at a singular end";
  return name + ", misses " + orderName(next) + " by " + amount(residual, next) + limit;
}

}  // namespace osculate
