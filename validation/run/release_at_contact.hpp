// SPDX-License-Identifier: BSD-3-Clause
// Bodies whose free motions are held until water touches them.
#pragma once

#include <vector>

#include "solver/simulation.hpp"
#include "validation/scene/scene.hpp"

namespace wetdeck {

/// Lets go of each body that waits for it when water first touches it, as the time origin `first_contact` has
/// it: within a step.
class ReleaseAtContact {
  public:
    explicit ReleaseAtContact(const Scene& scene);
    void operator()(Simulation& simulation) const;

  private:
    struct Waiting {
        std::size_t body;
        Outline outline;  ///< in the frame of the body [m]
    };
    std::vector<Waiting> waiting_;
};

}  // namespace wetdeck
