// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include <random>

namespace spherewalk::test {

/// Random values for laws that must hold for all inputs. Print the seed on failure:
/// SCOPED_TRACE(random.seed()).
class Random {
  public:
    explicit Random(unsigned seed) : m_seed(seed), m_engine(seed) {}

    unsigned seed() const { return m_seed; }

    double uniform(double least, double greatest) {
        return std::uniform_real_distribution<double>(least, greatest)(m_engine);
    }

    double normal(double sigma = 1) { return std::normal_distribution<double>(0, sigma)(m_engine); }

    int integer(int least, int greatest) {
        return std::uniform_int_distribution<int>(least, greatest)(m_engine);
    }

    Eigen::Vector3d vector(double sigma = 1) { return {normal(sigma), normal(sigma), normal(sigma)}; }

    Eigen::Vector3d direction() { return vector().normalized(); }

    Eigen::Quaterniond rotation() {
        return Eigen::Quaterniond(normal(), normal(), normal(), normal()).normalized();
    }

  private:
    unsigned m_seed;
    std::mt19937 m_engine;
};

} // namespace spherewalk::test
