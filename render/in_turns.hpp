#pragma once

#include <functional>
#include <vector>

#include "render/render.hpp"

namespace raycat {

/// A render that is timed: does its work with the settings that it is given, and no others.
using TimedRender = std::function<void(const RenderSettings& settings)>;

/// The CPU seconds of each of `renders`. They take turns, a row of the image each, on a thread of
/// their own, so that whatever slows a shared machine slows all alike: render by render, ratios of
/// their times are uncertain by several percent. `settings.progress` follows the first.
std::vector<double> cpu_seconds_in_turns(const std::vector<TimedRender>& renders,
                                         const RenderSettings& settings);

}  // namespace raycat
