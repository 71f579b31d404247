// SPDX-License-Identifier: BSD-3-Clause
// Physical viscosity in the intermediate pressure, Yang et al. (2020), Eq. (13):
//     P* += lambda mu_ij du / h,   mu_ij = 2 mu_i mu_j / (mu_i + mu_j)
// The paper applies it to approaching pairs only with lambda = 5 (2 + d)/4 = 5, which gives 5/8 of the
// viscosity asked for. For this kernel the effective viscosity is lambda/8 (one sign) or lambda/4 (both
// signs) of the nominal one, so the symmetric form takes lambda = 4.
#pragma once

namespace wetdeck {

enum class Viscosity { none, approaching, symmetric };

constexpr double viscosity_lambda(Viscosity form) {
    return form == Viscosity::approaching ? 5 : 4;
}

}  // namespace wetdeck
