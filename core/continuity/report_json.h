// The report of a join as JSON, schema osculate.join/1.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "osculate/continuity/curve_joins.h"

namespace osculate {

/// Keys as the attributes of the Python report; what does not exist is null, never NaN.
nlohmann::ordered_json toJson(const CurveJoin& join);

}  // namespace osculate
