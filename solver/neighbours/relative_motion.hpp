// SPDX-License-Identifier: BSD-3-Clause
// How much closer two particles can have come since their list was built.
//
// Two particles that were apart by D are now apart by |D + d_j - d_i| >= D - |d_j - d_i|, d their moves
// since. What flows together moves far and comes no closer: half the skin for each particle is the bound for
// two that fly at each other. So the plane is divided into blocks whose sides are longer than the reach R of
// the list. Two particles in the same block or in blocks that touch, by where they were when the list was
// built, have come closer by no more than the diagonal of the box around all moves of both blocks; all others
// were a side apart, and each has moved by no more than the longest move. What was not listed was further
// apart than R, and is out of the support S = R - skin as long as
//
//     approach = max(diagonals, 2 longest move - (side - R)) <= skin.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/core/vec2.hpp"
#include "solver/neighbours/cell_levels.hpp"

namespace wetdeck {

/// Moves by blocks of cells. Cells at the rim of the grid stand for all that is beyond it.
class RelativeMotion {
  public:
    /// @param reach  of the list: support and skin [m]
    /// @param skin  [m]
    RelativeMotion(const CellGrid& grid, double reach, double skin);

    std::uint32_t block_strips() const { return block_strips_; }  ///< strips of a block
    std::uint32_t block_rows() const { return block_rows_; }      ///< rows of a block
    std::uint32_t columns() const { return columns_; }            ///< blocks side by side
    std::uint32_t layers() const { return layers_; }              ///< blocks one above the other

    /// The box around the moves in the block that holds this cell; inverted where nothing has been there.
    Box& moves(CellGrid::Cell cell) { return moves_[block_of(cell)]; }
    /// The same of the block that holds a place.
    Box& moves(Vec2 place) { return moves(grid_.cell_of(place)); }

    /// Forgets all moves, but not what is at rest.
    void clear() { moves_ = at_rest_; }
    /// What is here stays where it is: the tank's walls.
    void keep_at_rest(Vec2 place) { at_rest_[block_of(grid_.cell_of(place))] = {Vec2::Zero(), Vec2::Zero()}; }

    /// The most that two particles which were not listed can have come closer [m].
    double approach(int threads) const;
    std::size_t bytes() const { return (moves_.capacity() + at_rest_.capacity()) * sizeof(Box); }

  private:
    std::size_t block_of(CellGrid::Cell cell) const {
        return std::size_t{cell.strip / block_strips_} * layers_ + cell.row / block_rows_;
    }

    CellGrid grid_;
    std::uint32_t block_strips_, block_rows_, columns_, layers_;
    double spare_;  ///< a block's shorter side less the reach [m]
    std::vector<Box> moves_, at_rest_;
};

}  // namespace wetdeck
