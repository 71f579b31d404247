// SPDX-License-Identifier: BSD-3-Clause
#include "solver/passes/rates.hpp"

#include "solver/bodies/contact.hpp"
#include "solver/physics/sponge.hpp"

namespace wetdeck {
namespace {

bool reads_means_in_density(const Model& model) {
    return model.wall_velocity == WallVelocity::mirrored || model.wall_wetting;
}

bool needs_wall_means(const Model& model) {
    return model.wall_pressure != WallPressure::one_sided || reads_means_in_density(model);
}

PassInput constants_of(const RatesSetup& setup, std::size_t fixed_walls) {
    const Model& model = setup.model;
    PassInput in;
    in.kernel = {model.smoothing_ratio * setup.particle_spacing};
    const double h = in.kernel.smoothing_length;
    for (std::size_t i = 0; i < phase_count; ++i) {
        for (std::size_t j = 0; j < phase_count; ++j)
            in.pair[i][j] = pair_coefficients(model, Phase(i), Phase(j), h);
        in.wall_pair[i] = wall_coefficients(model, Phase(i), h);
    }
    in.gravity = model.gravity;
    in.particle_spacing = setup.particle_spacing;
    in.wall_volume = setup.particle_spacing * setup.particle_spacing;
    in.coarsest = setup.coarsest;
    in.wetting = model.wall_wetting;
    in.smallest_velocity = 1e-12 * model.water.eos.sound_speed;
    in.smallest_pressure = 1e-12 * model.water.eos.coefficient();
    in.reference_density = {model.water.eos.reference_density, model.air.eos.reference_density};
    in.wall_pressure_mean = {model.wall_pressure != WallPressure::one_sided,
                             model.wall_pressure == WallPressure::shepard};
    in.fixed_walls = fixed_walls;
    if (setup.fast_water()) in.phase_of = {0, 0};
    return in;
}

NeighbourList list_for(const RatesSetup& setup, double skin, bool with_wall_lists) {
    const double support = 2 * setup.model.smoothing_ratio * setup.particle_spacing;
    const double slow_fineness = setup.fast_water() ? 1.0 / setup.model.coarse_substeps : 0;
    return {setup.domain,    setup.particle_spacing, support,        skin,
            with_wall_lists, setup.model.ends(),     setup.coarsest, slow_fineness};
}

}  // namespace

Rates::Rates(const RatesSetup& setup, Flow& flow)
    : setup_(setup),
      passes_(pair_passes(setup.model, setup.execution.instruction_set, setup.execution.precision,
                          setup.graded())),
      constants_(constants_of(setup, flow.walls.fixed)),
      list_(list_for(
          setup,
          (chooses_skin() ? skin_choice_.skin : setup.execution.skin) * constants_.kernel.smoothing_length,
          needs_wall_means(setup.model) || !flow.bodies.empty())),
      team_(setup.execution.threads, setup.execution.fewer_when_busy),
      met_(static_cast<std::size_t>(setup.execution.threads)),
      next_(static_cast<std::size_t>(setup.execution.threads)),
      listed_bodies_(flow.bodies) {
    for (RigidBody& body : flow.bodies) body.in_fast_water = setup.fast_water();
    list_.sort_fixed_walls(flow.walls);
    if (setup.execution.precision == Precision::mixed)
        mixed_.emplace(setup.domain, setup.coarsest * constants_.kernel.support_radius());
}

/// Sets what passes read of this flow.
void Rates::set_state(PassInput& in, const Flow& flow, const NeighbourList& list) const {
    in.model = &setup_.model;
    in.threads = team_.size();
    in.fluid = list.listed(flow.fluid);
    in.mixed = mixed_ ? &*mixed_ : nullptr;
    in.wall = flow.walls.state.data();
    in.wall_mean = flow.walls.mean.data();
    in.wall_own_sum = flow.walls.own_sum.data();
    in.wall_fineness = flow.walls.fineness.data();
    in.blocks = &list.blocks();
    in.clusters = shared(list, list.shares());
    in.wall_clusters = &list.wall_clusters();
}

PassInput Rates::inputs(const Flow& flow) const {
    PassInput in = constants_;
    set_state(in, flow, list_);
    copy_mixed_fluid(flow, list_);
    return in;
}

PassInput Rates::pass_input(Flow& flow, double substep_weight) const {
    PassInput in = constants_;
    set_state(in, flow, list_);
    in.slow_weight = substep_weight;
    if (substep_weight == 0) in.clusters = shared(list_, list_.fast_shares());
    const bool sums_water = substep_weight > 0 || setup_.fast_water();
    if (setup_.model.full_kernel_sum > 0 && sums_water) in.kernel_sum = flow.fluid.kernel_sum.data();
    in.new_wall_mean = flow.walls.mean.data();
    in.density_rate = flow.fluid.density_rate.data();
    in.acceleration_x = flow.fluid.acceleration_x.data();
    in.acceleration_y = flow.fluid.acceleration_y.data();
    in.wall_force_x = flow.walls.force_x.data();
    in.wall_force_y = flow.walls.force_y.data();
    return in;
}

void Rates::build_list(Flow& flow) {
    team_.adapt();
    list_.build(flow.fluid, flow.walls, passes_.filter_near, team_.size());
    listed_bodies_ = flow.bodies;
    forget_mixed_fluid();
    // boundary particles without fluid near are left out of the list
    std::fill(flow.walls.force_x.begin(), flow.walls.force_x.end(), 0.0);
    std::fill(flow.walls.force_y.begin(), flow.walls.force_y.end(), 0.0);
    ++list_builds_;
    summed_in_each_step_ = 0;
    for (const Cluster& cluster : list_.clusters())
        if (!cluster.rests) summed_in_each_step_ += cluster.count;
}

void Rates::refresh_list(Flow& flow, double farthest) {
    const StageTimer timer(stages_.neighbours);
    if (list_.slack() < 2 * farthest) bring_up(flow);  // the list looks where everything is
    ++skin_choice_.served;
    if (list_.still_complete(farthest, flow.fluid, flow.walls, team_.size())) return;
    skin_choice_.end_of_list();
    apply_skin(flow.walls);
    build_list(flow);
}

void Rates::apply_skin(const WallParticles& walls) {
    if (chooses_skin()) list_.set_skin(skin_choice_.skin * constants_.kernel.smoothing_length, walls);
}

void Rates::restore_skin(const SkinChoice& choice, const WallParticles& walls) {
    skin_choice_ = choice;
    apply_skin(walls);
}

bool Rates::means_in_density(double substep_weight) const {
    return (substep_weight > 0 || setup_.fast_water()) && reads_means_in_density(setup_.model);
}

void Rates::wall_means(Flow& flow, double substep_weight) {
    const bool for_fast = setup_.fast_water() || setup_.model.wall_pressure == WallPressure::shepard;
    if (!needs_wall_means(setup_.model) || (substep_weight == 0 && !for_fast)) return;
    const StageTimer timer(stages_.walls);
    passes_.wall_means(pass_input(flow, substep_weight));
}

/// Brings the fluid in single precision up to date where it is not.
void Rates::refresh_mixed_fluid(const Flow& flow) {
    if (!mixed_ || mixed_is_current_) return;
    copy_mixed_fluid(flow, list_);
    mixed_is_current_ = list_.listed_count(flow.fluid) == flow.fluid.size();  // nobody keeps up the images
}

void Rates::copy_mixed_fluid(const Flow& flow, const NeighbourList& list) const {
    if (!mixed_) return;
    mixed_->copy(list.listed(flow.fluid), list.listed_count(flow.fluid), team_.size());
    mixed_is_current_ = false;
}

void Rates::sum_pairs(Pass pass, Flow& flow, double substep_weight) {
    refresh_mixed_fluid(flow);
    const Team::Work work(team_);
    pass(pass_input(flow, substep_weight));
}

void Rates::density(Flow& flow, double substep_weight) {
    const StageTimer timer(stages_.density);
    sum_pairs(passes_.density_rates, flow, substep_weight);
    if (setup_.model.sponge_thickness > 0) apply_sponge_layer(flow.fluid, {&flow.fluid.density_rate});
}

void Rates::momentum(Flow& flow, double substep_weight) {
    const StageTimer timer(stages_.momentum);
    FluidParticles& fluid = flow.fluid;
    sum_pairs(passes_.accelerations, flow, substep_weight);
    if (const double frequency = setup_.model.central_frequency; frequency > 0) {
        for (std::size_t i = 0; i < fluid.size(); ++i) {
            const double pull = (i < list_.slow() ? substep_weight : 1) * (frequency * frequency);
            fluid.acceleration_x[i] -= pull * fluid.state[i].x;
            fluid.acceleration_y[i] -= pull * fluid.state[i].y;
        }
    }
    if (flow.tank_motion.moves()) {
        const FrameForces frame = frame_forces(flow);
        for (std::size_t i = 0; i < fluid.size(); ++i) {
            const FluidState& p = fluid.state[i];
            const Vec2 force = (i < list_.slow() ? substep_weight : 1) * frame.at(p.position(), p.velocity());
            fluid.acceleration_x[i] += force.x();
            fluid.acceleration_y[i] += force.y();
        }
    }
    if (setup_.model.sponge_thickness > 0)
        apply_sponge_layer(fluid, {&fluid.acceleration_x, &fluid.acceleration_y});
}

FrameForces Rates::frame_forces(const Flow& flow) const {
    return flow.tank_motion.moves() ? flow.tank_motion.forces(flow.time, setup_.model.gravity)
                                    : FrameForces{};
}

/// The sponge layer's factor on rates, Eqs. (24)-(25).
void Rates::apply_sponge_layer(const FluidParticles& fluid,
                               std::initializer_list<std::vector<double>*> rates) const {
    const double thickness = setup_.model.sponge_thickness;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const double distance = distance_to_wall(setup_.domain, fluid.state[i].x, fluid.state[i].y);
        if (distance >= thickness) continue;
        const double factor = sponge_factor(distance, thickness, setup_.model.sponge_ramp);
        for (std::vector<double>* rate : rates) (*rate)[i] *= factor;
    }
}

void Rates::body_loads(Flow& flow, double substep_weight, double remaining) {
    if (flow.bodies.empty()) return;
    const StageTimer timer(stages_.bodies);
    const FrameForces frame = frame_forces(flow);
    const auto gravity = [&](const RigidBody& body) -> Vec2 {
        return setup_.model.gravity + frame.at(body.position, body.velocity);
    };
    const auto own_load = [&](std::size_t b) {
        return setup_.model.mirror_x
                   ? load_on_both_halves(flow, b, setup_.domain.low.x(), setup_.particle_spacing)
                   : load_on(flow, b);
    };
    const auto load = [&](std::size_t b) {  // with those of what it carries
        BodyLoad sum = own_load(b);
        for (std::size_t other = b + 1; other < flow.bodies.size(); ++other) {
            if (flow.bodies[other].joined_to != b) continue;
            const BodyLoad more = own_load(other);
            const Vec2 arm = flow.bodies[other].position - flow.bodies[b].position;
            sum.force += more.force;
            sum.torque += more.torque + arm.x() * more.force.y() - arm.y() * more.force.x();
        }
        return sum;
    };
    PassInput in = pass_input(flow, substep_weight);
    if (substep_weight > 0) {
        in.loading = {true, false};
        passes_.body_forces(in);
        for (std::size_t b = 0; b < flow.bodies.size(); ++b)
            flow.bodies[b].set_slow_load(load(b), gravity(flow.bodies[b]));
    }
    const bool has_fast = list_.slow() < flow.fluid.size();
    if (has_fast) {
        in.loading = {false, true};
        passes_.body_forces(in);
    }
    const ContactLaw& contact = setup_.model.contact;
    if (contact.on()) set_contact_loads(flow.bodies, setup_.domain, contact);
    for (std::size_t b = 0; b < flow.bodies.size(); ++b) {
        RigidBody& body = flow.bodies[b];
        body.set_restraint(remaining);
        body.set_fast_load(has_fast ? load(b) : BodyLoad{}, gravity(body), flow.time,
                           frame.angular_acceleration);
    }
}

/// The pressure convection rate grad(p).v of Eq. (15) is taken from the momentum equation itself: grad(p) =
/// -rho (dv/dt - g).
void Rates::mark_impacts(Flow& flow, double fastest) {
    const StageTimer timer(stages_.integration);
    FluidParticles& fluid = flow.fluid;
    const Vec2 gravity = setup_.model.gravity;
    const double g = gravity.norm();
    const auto size = static_cast<std::int64_t>(fluid.size());
#pragma omp parallel for schedule(static) num_threads(team_.size())
    for (std::int64_t n = 0; n < size; ++n) {
        const auto i = static_cast<std::size_t>(n);
        FluidState& p = fluid.state[i];
        const double rate = -p.density * ((fluid.acceleration_x[i] - gravity.x()) * p.vx +
                                          (fluid.acceleration_y[i] - gravity.y()) * p.vy);
        p.impact = rate > p.density * g * fastest ? 1 : 0;
    }
}

double Rates::momentum_error(const Flow& flow) const {
    if (list_.with_walls_own_lists()) return momentum_error(inputs(flow), flow);
    // the reactions of the tank are summed from lists that this run does without
    Flow copy = flow;
    NeighbourList list = list_for(setup_, 0, true);
    list.sort_fixed_walls(copy.walls);
    list.build(copy.fluid, copy.walls, passes_.filter_near, team_.size());
    PassInput in = constants_;
    set_state(in, copy, list);
    copy_mixed_fluid(copy, list);
    return momentum_error(in, copy);
}

double Rates::momentum_error(PassInput in, const Flow& flow) const {
    const FluidParticles& fluid = flow.fluid;
    const WallParticles& walls = flow.walls;
    std::vector<double> ax(fluid.size()), ay(fluid.size()), fx(walls.size(), 0), fy(walls.size(), 0);
    in.acceleration_x = ax.data();
    in.acceleration_y = ay.data();
    in.wall_force_x = fx.data();
    in.wall_force_y = fy.data();
    in.fixed_walls = 0;  // the reactions of the tank, too
    passes_.accelerations(in);
    passes_.body_forces(in);
    Vec2 sum = Vec2::Zero();
    double sizes = 0;
    const auto add = [&](Vec2 force) {
        sum += force;
        sizes += force.norm();
    };
    for (std::size_t i = 0; i < fluid.size(); ++i)
        add(fluid.mass[i] * (Vec2(ax[i], ay[i]) - setup_.model.gravity));
    for (std::size_t n = 0; n < walls.size(); ++n) {
        const double x = walls.state[n].x;  // walls run on beyond the ends of a periodic domain
        const bool inside = x >= setup_.domain.low.x() && x < setup_.domain.high.x();
        if (setup_.model.mirror_x)
            add(share_of_half(x - setup_.domain.low.x(), setup_.particle_spacing) * Vec2(fx[n], fy[n]));
        else if (inside || !setup_.model.periodic_x)
            add({fx[n], fy[n]});
    }
    if (setup_.model.mirror_x) sum.x() = 0;  // what the other half presses with
    return sizes > 0 ? sum.norm() / sizes : 0;
}

}  // namespace wetdeck
