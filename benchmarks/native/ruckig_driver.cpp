// Times Ruckig's calculate in C++ on the problems of batch.h, without their snap limits.
#include <chrono>
#include <cmath>
#include <vector>

#include <ruckig/ruckig.hpp>

#include "batch.h"

namespace {

using Clock = std::chrono::steady_clock;

double microseconds(Clock::duration taken)
{
    return std::chrono::duration<double, std::micro>(taken).count();
}

template <size_t Axes>
std::vector<ruckig::InputParameter<Axes>> inputs(const batch &b)
{
    std::vector<ruckig::InputParameter<Axes>> all(b.count);
    for (int64_t i = 0; i < b.count; i++) {
        auto &input = all[i];
        for (size_t axis = 0; axis < Axes; axis++) {
            const size_t start = 2 * Axes * i + axis, end = start + Axes;
            const double *limits = b.limits + (Axes * i + axis) * (b.smoothness + 1);
            input.current_position[axis] = b.positions[start];
            input.current_velocity[axis] = b.velocities[start];
            input.current_acceleration[axis] = b.accelerations[start];
            input.target_position[axis] = b.positions[end];
            input.target_velocity[axis] = b.velocities[end];
            input.target_acceleration[axis] = b.accelerations[end];
            input.max_velocity[axis] = limits[0];
            input.max_acceleration[axis] = limits[1];
            input.max_jerk[axis] = limits[2];
        }
    }
    return all;
}

template <size_t Axes>
double run(const batch &b)
{
    const auto all = inputs<Axes>(b);
    ruckig::Ruckig<Axes> planner;
    ruckig::Trajectory<Axes> trajectory;
    const auto begun = Clock::now();
    for (int64_t i = 0; i < b.count; i++) {
        const auto before = b.times ? Clock::now() : begun;
        const auto result = planner.calculate(all[i], trajectory);
        b.durations[i] = result == ruckig::Result::Working ? trajectory.get_duration() : NAN;
        if (b.times) {
            b.times[i] = microseconds(Clock::now() - before);
        }
    }
    return microseconds(Clock::now() - begun);
}

}  // namespace

extern "C" double run_ruckig(const batch *b)
{
    return b->axes == 1 ? run<1>(*b) : run<3>(*b);
}
