// SPDX-License-Identifier: BSD-3-Clause
#include "solver/neighbours/neighbour_list.hpp"

#include <algorithm>
#include <cmath>

#include "solver/neighbours/counting_sort.hpp"

namespace wetdeck {
namespace {

constexpr std::size_t clusters_per_block = 32;

/// @param fineness  of the particle with an index
template <class State, class Fineness>
ClusterPoints points_of(const State* state, const Cluster& cluster, Fineness fineness) {
    ClusterPoints points;
    for (std::uint32_t lane = 0; lane < cluster_width; ++lane) {
        const State& particle = state[cluster.at(lane)];
        points.x[lane] = particle.x;
        points.y[lane] = particle.y;
        points.half_fineness[lane] = 0.5 * fineness(cluster.at(lane));
    }
    return points;
}

Box bounds(const ClusterPoints& points) {
    Box box = empty_box();
    for (std::uint32_t lane = 0; lane < cluster_width; ++lane) extend(box, {points.x[lane], points.y[lane]});
    return box;
}

Box widened(Box box, double margin) {
    return {box.low - Vec2::Constant(margin), box.high + Vec2::Constant(margin)};
}

}  // namespace

NeighbourList::NeighbourList(Box domain, double particle_spacing, double support_radius, double skin,
                             bool with_walls_own_lists, DomainEnds ends, double coarsest,
                             double slow_fineness)
    : grid_(grid_over(widened(domain, coarsest * support_radius + skin), particle_spacing)),
      reach_{support_radius, skin},
      coarsest_(coarsest),
      graded_(coarsest > 1),
      motion_(grid_, farthest_reach(), skin),
      with_walls_own_lists_(with_walls_own_lists),
      slow_fineness_(slow_fineness),
      fluid_cells_(grid_, coarsest),
      image_cells_(grid_, coarsest),
      fixed_cells_(grid_, coarsest),
      body_cells_(grid_, coarsest) {
    // walls run on beyond the ends by a support, and see the fluid around themselves
    if (ends != DomainEnds::walls) images_.emplace(ends, domain, 2 * farthest_reach());
}

void NeighbourList::sort_fixed_walls(WallParticles& walls) {
    sort_walls(walls, 0, walls.fixed, fixed_cells_);
    set_skin(skin(), walls);
}

void NeighbourList::set_skin(double skin, const WallParticles& walls) {
    const double room = images_ ? images_->largest_depth() / 2 - reach_.support * coarsest_ : skin;
    reach_.skin = std::min(skin, room);
    if (images_) images_->set_depth(2 * farthest_reach());
    motion_ = RelativeMotion(grid_, farthest_reach(), reach_.skin);
    for (std::size_t n = 0; n < walls.fixed; ++n) motion_.keep_at_rest({walls.state[n].x, walls.state[n].y});
}

void NeighbourList::sort_walls(WallParticles& walls, std::size_t begin, std::size_t end, CellLevels& cells) {
    const std::size_t count = end - begin;
    const auto place = [&](std::size_t i) {
        return Vec2(walls.state[begin + i].x, walls.state[begin + i].y);
    };
    cells.fit(count, place, [&](std::size_t i) { return walls.fineness[begin + i]; });
    key_.resize(count);
    for (std::size_t i = 0; i < count; ++i) key_[i] = cells.cell_of(place(i), walls.fineness[begin + i]);
    counting_sort(key_, cells.count(), cells.start, order_);
    for (std::uint32_t& s : cells.start) s += static_cast<std::uint32_t>(begin);
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
    if (walls.size() > walls.fixed) sort_walls(walls, walls.fixed, walls.size(), body_cells_);
    clusters_.clear();
    fluid_cells_.append_clusters(clusters_, 0, Phase::water);
    fluid_cells_.append_clusters(clusters_, 1, slow_fineness_ > 0 ? Phase::water : Phase::air);
    built_body_.clear();
    for (std::size_t n = walls.fixed; n < walls.size(); ++n)
        built_body_.emplace_back(walls.state[n].x, walls.state[n].y);
    slack_ = skin();
    list_neighbours(fluid, walls, near, threads);
}

bool NeighbourList::still_complete(double farthest, const FluidParticles& fluid, const WallParticles& walls,
                                   int threads) {
    slack_ -= 2 * farthest;
    if (slack_ < 0) {
        collect_moves(fluid, walls, threads);
        slack_ = skin() - motion_.approach(threads);
    }
    return slack_ >= 0;
}

/// Moves since the last build, by where the particles were then.
void NeighbourList::collect_moves(const FluidParticles& fluid, const WallParticles& walls, int threads) {
    motion_.clear();
    const auto move = [&](std::uint32_t i) -> Vec2 { return fluid.state[i].position() - built_at(i); };
    if (graded_) {
        for (std::uint32_t i = 0; i < fluid.size(); ++i) extend(motion_.moves(built_at(i)), move(i));
    } else {
        const auto columns = static_cast<std::int64_t>(motion_.columns());
        const auto cells = static_cast<std::uint32_t>(fluid_cells_.count());
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
        for (std::int64_t n = 0; n < columns; ++n) {
            const std::uint32_t first_strip = static_cast<std::uint32_t>(n) * motion_.block_strips();
            const std::uint32_t end_strip = std::min(grid_.strips, first_strip + motion_.block_strips());
            for (std::uint32_t strip = first_strip; strip < end_strip; ++strip) {
                for (std::uint32_t row = 0; row < grid_.rows; row += motion_.block_rows()) {
                    const std::uint32_t end_row = std::min(grid_.rows, row + motion_.block_rows());
                    Box& block = motion_.moves(CellGrid::Cell{strip, row});
                    Box moves = block;
                    for (std::uint32_t group = 0; group < group_count; ++group) {
                        const std::uint32_t* start =
                            fluid_cells_.start.data() + group * cells + strip * grid_.rows;
                        for (std::uint32_t i = start[row]; i < start[end_row]; ++i) extend(moves, move(i));
                    }
                    block = moves;
                }
            }
        }
    }
    for (std::size_t n = 0; n < built_body_.size(); ++n) {
        const WallState& p = walls.state[walls.fixed + n];
        extend(motion_.moves(built_body_[n]), Vec2(p.x, p.y) - built_body_[n]);
    }
    if (!images_) return;
    for (const DomainImages::Image& image : images_->images())
        extend(motion_.moves(image.place(built_at(image.source))), image.turn(move(image.source)));
}

void NeighbourList::sort_fluid(FluidParticles& fluid, int threads) {
    fluid_cells_.fit(
        fluid.size(), [&](std::size_t i) { return fluid.state[i].position(); },
        [&](std::size_t i) { return fluid.state[i].fineness; });
    key_.resize(fluid.size());
    const auto cells = static_cast<std::uint32_t>(fluid_cells_.count());
    const auto size = static_cast<std::int64_t>(fluid.size());
#pragma omp parallel for schedule(static) num_threads(threads)
    for (std::int64_t n = 0; n < size; ++n) {
        const auto i = static_cast<std::size_t>(n);
        const FluidState& p = fluid.state[i];
        key_[i] = fluid_cells_.cell_of(p.position(), fineness_of(p)) + group_of(fluid, i) * cells;
    }
    counting_sort(key_, group_count * cells, fluid_cells_.start, order_);
    slow_ = fluid_cells_.start[cells];
    built_.resize(2 * fluid.size());
    reorder(fluid, threads);
#pragma omp parallel for schedule(static) num_threads(threads)
    for (std::int64_t n = 0; n < size; ++n) {
        const auto i = static_cast<std::size_t>(n);
        built_[2 * i] = fluid.state[i].x;
        built_[2 * i + 1] = fluid.state[i].y;
    }
}

/// Brings the fields that follow their particles into the order. Accelerations, which are computed anew, and
/// the positions of the last build give the room for it, four numbers of a particle at a time.
void NeighbourList::reorder(FluidParticles& fluid, int threads) {
    const auto size = static_cast<std::int64_t>(fluid.size());
    constexpr std::size_t most = 4;
    const std::array<double*, most> room{fluid.acceleration_x.data(), fluid.acceleration_y.data(),
                                         built_.data(), built_.data() + fluid.size()};
    for_each_field(fluid, [&](const auto& field, auto& values) {
        if (field.sorted == Sorted::no) return;
        if constexpr (sizeof(values[0]) == sizeof(key_[0])) {
#pragma omp parallel for schedule(static) num_threads(threads)
            for (std::int64_t n = 0; n < size; ++n)
                key_[static_cast<std::size_t>(n)] = values[order_[static_cast<std::size_t>(n)]];
            std::swap(values, key_);
        } else {
            constexpr std::size_t width = sizeof(values[0]) / sizeof(double);
            auto* const numbers = reinterpret_cast<double*>(values.data());
            for (std::size_t first = 0; first < width; first += most) {
                const std::size_t count = std::min(most, width - first);
#pragma omp parallel num_threads(threads)
                {
#pragma omp for schedule(static)
                    for (std::int64_t n = 0; n < size; ++n) {
                        const auto i = static_cast<std::size_t>(n);
                        const double* from = numbers + width * order_[i] + first;
                        for (std::size_t k = 0; k < count; ++k) room[k][i] = from[k];
                    }
#pragma omp for schedule(static)
                    for (std::int64_t n = 0; n < size; ++n) {
                        const auto i = static_cast<std::size_t>(n);
                        double* to = numbers + width * i + first;
                        for (std::size_t k = 0; k < count; ++k) to[k] = room[k][i];
                    }
                }
            }
        }
    });
}

/// Sorts the images like the fluid: by group, then along the grid.
void NeighbourList::place_images(const FluidParticles& fluid) {
    images_->choose(fluid);
    const std::vector<DomainImages::Image>& images = images_->images();
    const auto source = [&](std::size_t n) -> const FluidState& { return fluid.state[images[n].source]; };
    const auto place = [&](std::size_t n) { return images[n].place(source(n).position()); };
    image_cells_.fit(images.size(), place, [&](std::size_t n) { return source(n).fineness; });
    const auto cells = static_cast<std::uint32_t>(image_cells_.count());
    key_.clear();
    for (std::size_t n = 0; n < images.size(); ++n)
        key_.push_back(image_cells_.cell_of(place(n), fineness_of(source(n))) +
                       group_of(fluid, images[n].source) * cells);
    counting_sort(key_, group_count * cells, image_cells_.start, order_);
    images_->reorder(order_);
    for (std::uint32_t& start : image_cells_.start) start += static_cast<std::uint32_t>(fluid.size());
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
        fixed_cells_.append_clusters(wall_clusters_, 0, Phase::water);
        if (walls.size() > walls.fixed) body_cells_.append_clusters(wall_clusters_, 0, Phase::water);
    }
    const std::size_t total = clusters_.size() + wall_clusters_.size();
    const std::size_t blocks = (total + clusters_per_block - 1) / clusters_per_block;
    if (blocks_.size() < blocks) blocks_.resize(blocks);
    const Search search{fluid, listed(fluid), walls, near};
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
    for (std::int64_t block = 0; block < static_cast<std::int64_t>(blocks); ++block)
        list_block(search, static_cast<std::size_t>(block));
    shares_ = equal_shares(clusters_, threads);
    fast_shares_ = equal_shares(clusters_, threads, Pairs::with_fast);
    std::erase_if(wall_clusters_,
                  [](const Cluster& c) { return c.fluid_neighbours[0] + c.fluid_neighbours[1] == 0; });
}

/// The neighbours of the clusters of one block, appended to its list one after the other.
void NeighbourList::list_block(const Search& search, std::size_t block) {
    constexpr std::size_t line = sizeof(FluidState) / sizeof(double);
    const auto of_fluid = [&](std::uint32_t i) { return fineness_of(search.fluid.state[i]); };
    const auto of_walls = [&](std::uint32_t i) { return search.walls.fineness[i]; };
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
        const ClusterPoints points = of_wall ? points_of(walls.state.data(), cluster, of_walls)
                                             : points_of(fluid.state.data(), cluster, of_fluid);
        const Box box = bounds(points);
        const double half_fineness =
            *std::min_element(std::begin(points.half_fineness), std::end(points.half_fineness));
        const auto add_near = [&](const Places& places, std::size_t group) {
            const std::size_t before = used;
            places.cells.for_each_run(
                box, half_fineness, reach_, group, [&](std::uint32_t begin, std::uint32_t end) {
                    const std::size_t most = used + (end - begin) + cluster_width;
                    if (list.size() < most) {
                        list.reserve(most + most / 8);  // by itself it would double
                        list.resize(list.capacity());
                    }
                    const Candidates candidates{places.positions, places.stride,         begin, end,
                                                places.fineness,  places.fineness_stride};
                    used += search.near(points, candidates, reach_, list.data() + used);
                });
            return static_cast<std::uint32_t>(used - before);
        };
        const double* fineness = &search.listed->fineness;
        const Places in_fluid{fluid_cells_, built_.data(), 2, fineness, line};
        const Places in_images{image_cells_, &search.listed->x, line, fineness, line};
        for (std::size_t group = 0; group < group_count; ++group) {
            std::uint32_t& count = cluster.fluid_neighbours[group];
            count = fluid.size() == 0 ? 0 : add_near(in_fluid, group);
            if (images_) count += add_near(in_images, group);
        }
        cluster.wall_neighbours = 0;
        if (of_wall) continue;
        for (const CellLevels* cells : {&fixed_cells_, &body_cells_}) {
            if (cells == &fixed_cells_ ? walls.fixed == 0 : walls.size() == walls.fixed) continue;
            cluster.wall_neighbours +=
                add_near({*cells, &walls.state[0].x, line, walls.fineness.data(), 1}, 0);
        }
        // means at walls that fine water meets are also those of the coarse water beside it
        const bool in_means = slow_fineness_ > 0 && cluster.wall_neighbours > 0;
        cluster.rests = cluster.slow && cluster.fluid_neighbours[1] == 0 && !in_means;
    }
}

std::size_t NeighbourList::entries() const {
    std::size_t sum = 0;
    for (const Cluster& c : clusters_)
        sum += c.fluid_neighbours[0] + c.fluid_neighbours[1] + c.wall_neighbours;
    return sum;
}

std::size_t NeighbourList::bytes() const {
    std::size_t sum =
        (clusters_.capacity() + wall_clusters_.capacity()) * sizeof(Cluster) +
        built_.capacity() * sizeof(double) + built_body_.capacity() * sizeof(Vec2) + motion_.bytes() +
        (key_.capacity() + order_.capacity() + fluid_cells_.start.capacity() + image_cells_.start.capacity() +
         fixed_cells_.start.capacity() + body_cells_.start.capacity()) *
            sizeof(std::uint32_t);
    for_each_field(sorted_walls_,
                   [&sum](const auto&, const auto& values) { sum += values.capacity() * sizeof(values[0]); });
    for (const auto& block : blocks_) sum += block.capacity() * sizeof(std::uint32_t);
    return sum;
}

}  // namespace wetdeck
