// SPDX-License-Identifier: BSD-3-Clause
#include "solver/neighbours/neighbour_list.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace wetdeck {
namespace {

constexpr std::size_t clusters_per_block = 32;

/// Order of `keys` under a stable counting sort; `start` receives the first position of each key and an end
/// mark.
void counting_sort(std::span<const std::uint32_t> keys, std::size_t key_count,
                   std::vector<std::uint32_t>& start, std::vector<std::uint32_t>& order) {
    start.assign(key_count + 1, 0);
    for (const std::uint32_t key : keys) ++start[key + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    order.resize(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) order[start[keys[i]]++] = static_cast<std::uint32_t>(i);
    std::copy_backward(start.begin(), start.end() - 1, start.end());
    start[0] = 0;
}

template <class State>
ClusterPoints points_of(const State* state, const Cluster& cluster) {
    ClusterPoints points;
    for (std::uint32_t lane = 0; lane < cluster_width; ++lane) {
        const State& particle = state[cluster.at(lane)];
        points.x[lane] = particle.x;
        points.y[lane] = particle.y;
    }
    return points;
}

Box bounds(const ClusterPoints& points) {
    const auto [left, right] = std::minmax_element(std::begin(points.x), std::end(points.x));
    const auto [low, high] = std::minmax_element(std::begin(points.y), std::end(points.y));
    return {{*left, *low}, {*right, *high}};
}

CellGrid grid_over(Box domain, double particle_spacing, double margin) {
    CellGrid grid{3.2 * particle_spacing, particle_spacing, 0, 0};
    const Vec2 size = domain.high - domain.low + Vec2::Constant(2 * margin);
    grid.strips = static_cast<std::uint32_t>(std::ceil(size.x() / grid.cell_width)) + 1;
    grid.rows = static_cast<std::uint32_t>(std::ceil(size.y() / grid.cell_height)) + 1;
    return grid;
}

void append_clusters(std::vector<Cluster>& clusters, std::size_t begin, std::size_t end, Phase phase) {
    for (std::size_t first = begin; first < end; first += cluster_width) {
        Cluster cluster;
        cluster.first = static_cast<std::uint32_t>(first);
        cluster.count = static_cast<std::uint32_t>(std::min<std::size_t>(cluster_width, end - first));
        cluster.phase = phase;
        clusters.push_back(cluster);
    }
}

}  // namespace

NeighbourList::NeighbourList(Box domain, double particle_spacing, double support_radius, double skin,
                             bool with_walls_own_lists, DomainEnds ends)
    : origin_(domain.low - Vec2::Constant(support_radius + skin)),
      grid_(grid_over(domain, particle_spacing, support_radius + skin)),
      reach_(support_radius + skin),
      skin_(skin),
      motion_(grid_, reach_, skin),
      with_walls_own_lists_(with_walls_own_lists) {
    // walls run on beyond the ends by a support, and see the fluid around themselves
    if (ends != DomainEnds::walls) images_.emplace(ends, domain, 2 * reach_);
}

NeighbourList::Cell NeighbourList::cell_of(double x, double y) const {
    const auto clamped = [](double offset, double width, std::uint32_t count) {
        return static_cast<std::uint32_t>(std::clamp(offset / width, 0.0, static_cast<double>(count - 1)));
    };
    return {clamped(x - origin_.x(), grid_.cell_width, grid_.strips),
            clamped(y - origin_.y(), grid_.cell_height, grid_.rows)};
}

void NeighbourList::sort_fixed_walls(WallParticles& walls) {
    sort_walls(walls, 0, walls.fixed, fixed_start_);
    for (std::size_t n = 0; n < walls.fixed; ++n) {
        const Cell cell = cell_of(walls.state[n].x, walls.state[n].y);
        motion_.keep_at_rest(cell.strip, cell.row);
    }
}

void NeighbourList::sort_walls(WallParticles& walls, std::size_t begin, std::size_t end,
                               std::vector<std::uint32_t>& start) {
    const std::size_t count = end - begin;
    key_.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        key_[i] = cell_index(cell_of(walls.state[begin + i].x, walls.state[begin + i].y));
    counting_sort(key_, cells(), start, order_);
    for (std::uint32_t& s : start) s += static_cast<std::uint32_t>(begin);
    for_each_field(sorted_walls_, [&](const auto& field, auto& sorted) {
        if (field.sorted == Sorted::no) return;
        auto& values = walls.*field.values;
        sorted.resize(count);
        for (std::size_t i = 0; i < count; ++i) sorted[i] = values[begin + order_[i]];
        std::copy(sorted.begin(), sorted.end(), values.begin() + static_cast<std::ptrdiff_t>(begin));
    });
}

void NeighbourList::build(FluidParticles& fluid, WallParticles& walls, NearFilter near, int threads) {
    if (images_) images_->wrap(fluid);
    sort_fluid(fluid, threads);
    if (images_) place_images(fluid);
    if (walls.size() > walls.fixed) sort_walls(walls, walls.fixed, walls.size(), body_start_);
    clusters_.clear();
    append_clusters(clusters_, 0, fluid.water, Phase::water);
    append_clusters(clusters_, fluid.water, fluid.size(), Phase::air);
    built_body_.clear();
    for (std::size_t n = walls.fixed; n < walls.size(); ++n)
        built_body_.emplace_back(walls.state[n].x, walls.state[n].y);
    slack_ = skin_;
    list_neighbours(fluid, walls, near, threads);
}

bool NeighbourList::still_complete(double farthest, const FluidParticles& fluid, const WallParticles& walls,
                                   int threads) {
    slack_ -= 2 * farthest;
    if (slack_ < 0) {
        collect_moves(fluid, walls, threads);
        slack_ = skin_ - motion_.approach(threads);
    }
    return slack_ >= 0;
}

/// Moves since the last build, by where the particles were then.
void NeighbourList::collect_moves(const FluidParticles& fluid, const WallParticles& walls, int threads) {
    motion_.clear();
    const auto move = [&](std::uint32_t i) -> Vec2 { return fluid.state[i].position() - built_at(i); };
    const auto columns = static_cast<std::int64_t>(motion_.columns());
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
    for (std::int64_t n = 0; n < columns; ++n) {
        const std::uint32_t first_strip = static_cast<std::uint32_t>(n) * motion_.block_strips();
        const std::uint32_t end_strip = std::min(grid_.strips, first_strip + motion_.block_strips());
        for (std::uint32_t strip = first_strip; strip < end_strip; ++strip) {
            for (std::uint32_t row = 0; row < grid_.rows; row += motion_.block_rows()) {
                const std::uint32_t end_row = std::min(grid_.rows, row + motion_.block_rows());
                Box moves = motion_.moves(strip, row);
                for (std::size_t phase = 0; phase < phase_count; ++phase) {
                    const std::uint32_t* start =
                        fluid_start_.data() + phase * cells() + cell_index({strip, 0});
                    for (std::uint32_t i = start[row]; i < start[end_row]; ++i) extend(moves, move(i));
                }
                motion_.moves(strip, row) = moves;
            }
        }
    }
    const auto extend_at = [&](Vec2 place, Vec2 by) {
        const Cell cell = cell_of(place.x(), place.y());
        extend(motion_.moves(cell.strip, cell.row), by);
    };
    for (std::size_t n = 0; n < built_body_.size(); ++n) {
        const WallState& p = walls.state[walls.fixed + n];
        extend_at(built_body_[n], Vec2(p.x, p.y) - built_body_[n]);
    }
    if (!images_) return;
    for (const DomainImages::Image& image : images_->images())
        extend_at(image.place(built_at(image.source)), image.turn(move(image.source)));
}

void NeighbourList::sort_fluid(FluidParticles& fluid, int threads) {
    key_.resize(fluid.size());
    const auto size = static_cast<std::int64_t>(fluid.size());
#pragma omp parallel for schedule(static) num_threads(threads)
    for (std::int64_t n = 0; n < size; ++n) {
        const auto i = static_cast<std::size_t>(n);
        key_[i] = sort_key(fluid.state[i].x, fluid.state[i].y, fluid.phase(i));
    }
    counting_sort(key_, phase_count * cells(), fluid_start_, order_);
    for_each_field(fluid, [&](const auto& field, auto& values) {
        if (field.sorted == Sorted::no) return;
        auto& sorted = sorted_.*field.values;
        sorted.resize(fluid.size());
#pragma omp parallel for schedule(static) num_threads(threads)
        for (std::int64_t n = 0; n < size; ++n) {
            const auto i = static_cast<std::size_t>(n);
            sorted[i] = values[order_[i]];
        }
        std::swap(values, sorted);
    });
    built_.resize(2 * fluid.size());
#pragma omp parallel for schedule(static) num_threads(threads)
    for (std::int64_t n = 0; n < size; ++n) {
        const auto i = static_cast<std::size_t>(n);
        built_[2 * i] = fluid.state[i].x;
        built_[2 * i + 1] = fluid.state[i].y;
    }
}

/// Sorts the images like the fluid: by phase, then along the grid.
void NeighbourList::place_images(const FluidParticles& fluid) {
    images_->choose(fluid);
    key_.clear();
    for (const DomainImages::Image& image : images_->images()) {
        const FluidState& p = fluid.state[image.source];
        const Vec2 at = image.place(p.position());
        key_.push_back(sort_key(at.x(), at.y(), fluid.phase(image.source)));
    }
    counting_sort(key_, phase_count * cells(), image_start_, order_);
    images_->reorder(order_);
    for (std::uint32_t& start : image_start_) start += static_cast<std::uint32_t>(fluid.size());
}

/// What the search for the neighbours of every cluster reads.
struct NeighbourList::Search {
    const FluidParticles& fluid;
    const FluidState* listed;  ///< the fluid and its images
    const WallParticles& walls;
    NearFilter near;
};

void NeighbourList::list_neighbours(const FluidParticles& fluid, const WallParticles& walls, NearFilter near,
                                    int threads) {
    if (with_walls_own_lists_) {
        wall_clusters_.clear();
        append_clusters(wall_clusters_, 0, walls.fixed, Phase::water);
        append_clusters(wall_clusters_, walls.fixed, walls.size(), Phase::water);
    }
    const std::size_t total = clusters_.size() + wall_clusters_.size();
    const std::size_t blocks = (total + clusters_per_block - 1) / clusters_per_block;
    if (blocks_.size() < blocks) blocks_.resize(blocks);
    const Search search{fluid, listed(fluid), walls, near};
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
    for (std::int64_t block = 0; block < static_cast<std::int64_t>(blocks); ++block)
        list_block(search, static_cast<std::size_t>(block));
    shares_ = equal_shares(clusters_, threads);
    air_shares_ = equal_shares(clusters_, threads, Pairs::with_air);
    std::erase_if(wall_clusters_,
                  [](const Cluster& c) { return c.fluid_neighbours[0] + c.fluid_neighbours[1] == 0; });
}

/// The neighbours of the clusters of one block, appended to its list one after the other.
void NeighbourList::list_block(const Search& search, std::size_t block) {
    constexpr std::size_t line = sizeof(FluidState) / sizeof(double);
    const FluidParticles& fluid = search.fluid;
    const WallParticles& walls = search.walls;
    std::vector<std::uint32_t>& list = blocks_[block];
    std::size_t used = 0;
    const std::size_t total = clusters_.size() + wall_clusters_.size();
    const std::size_t last = std::min(total, (block + 1) * clusters_per_block);
    for (std::size_t n = block * clusters_per_block; n < last; ++n) {
        const bool of_wall = n >= clusters_.size();
        Cluster& cluster = of_wall ? wall_clusters_[n - clusters_.size()] : clusters_[n];
        cluster.block = static_cast<std::uint32_t>(block);
        cluster.offset = static_cast<std::uint32_t>(used);
        const ClusterPoints points =
            of_wall ? points_of(walls.state.data(), cluster) : points_of(fluid.state.data(), cluster);
        const Box box = bounds(points);
        const Cell low = cell_of(box.low.x() - reach_, box.low.y() - reach_);
        const Cell high = cell_of(box.high.x() + reach_, box.high.y() + reach_);
        const auto add_near = [&](const double* positions, std::size_t stride, const std::uint32_t* start) {
            const std::size_t before = used;
            for (std::uint32_t strip = low.strip; strip <= high.strip; ++strip) {
                const std::uint32_t begin = start[cell_index({strip, low.row})];
                const std::uint32_t end = start[cell_index({strip, high.row}) + 1];
                if (begin == end) continue;
                // one entry of slack: the filter writes each candidate before it knows whether to keep it
                const std::size_t most = used + (end - begin) + 1;
                if (list.size() < most) {
                    list.reserve(most + most / 8);  // by itself it would double
                    list.resize(list.capacity());
                }
                used += search.near(points, {positions, stride, begin, end}, reach_, list.data() + used);
            }
            return static_cast<std::uint32_t>(used - before);
        };
        for (std::size_t phase = 0; phase < phase_count; ++phase) {
            std::uint32_t& count = cluster.fluid_neighbours[phase];
            count = fluid.size() == 0 ? 0 : add_near(built_.data(), 2, fluid_start_.data() + phase * cells());
            if (images_) count += add_near(&search.listed->x, line, image_start_.data() + phase * cells());
        }
        cluster.wall_neighbours = 0;
        if (of_wall) continue;
        if (walls.fixed > 0)
            cluster.wall_neighbours += add_near(&walls.state[0].x, line, fixed_start_.data());
        if (walls.size() > walls.fixed)
            cluster.wall_neighbours += add_near(&walls.state[0].x, line, body_start_.data());
    }
}

std::size_t NeighbourList::entries() const {
    std::size_t sum = 0;
    for (const Cluster& c : clusters_)
        sum += c.fluid_neighbours[0] + c.fluid_neighbours[1] + c.wall_neighbours;
    return sum;
}

std::size_t NeighbourList::bytes() const {
    std::size_t sum = (clusters_.capacity() + wall_clusters_.capacity()) * sizeof(Cluster) +
                      built_.capacity() * sizeof(double) + built_body_.capacity() * sizeof(Vec2) +
                      motion_.bytes() +
                      (key_.capacity() + order_.capacity() + fluid_start_.capacity() +
                       image_start_.capacity() + fixed_start_.capacity() + body_start_.capacity()) *
                          sizeof(std::uint32_t);
    const auto add = [&sum](const auto&, const auto& values) {
        sum += values.capacity() * sizeof(values[0]);
    };
    for_each_field(sorted_, add);
    for_each_field(sorted_walls_, add);
    for (const auto& block : blocks_) sum += block.capacity() * sizeof(std::uint32_t);
    return sum;
}

}  // namespace wetdeck
