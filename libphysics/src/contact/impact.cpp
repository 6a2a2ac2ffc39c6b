// SPDX-License-Identifier: MIT
#include "contact/impact.h"

#include "contact/slip_energy.h"

#include <cmath>

namespace phys {

namespace {

constexpr uint32_t kMostRounds = 64;
constexpr int kMostSweeps = 4000;

/// A contact that takes part in a round.
struct Hit {
    uint32_t contact;
    Vec3 normal;
    double wanted;   ///< change of the normal speed that it asks for, m/s, > 0
    double friction; ///< Coulomb coefficient
    double impulse = 0.0;
};

struct Round {
    std::array<Hit, Contacts::kMost> hits;
    uint32_t count = 0;

    Hit *begin() { return hits.data(); }
    Hit *end() { return begin() + count; }
};

double kineticEnergy(const Motion &motion, double radius) {
    return 0.5 * glm::dot(motion.velocity, motion.velocity) +
           0.2 * radius * radius * glm::dot(motion.spin, motion.spin);
}

Vec3 sumOfImpulses(Round &round) {
    Vec3 change(0.0);
    for (const Hit &hit : round) change += hit.impulse * hit.normal;
    return change;
}

/// By how much the impulses miss: a hit gets less than it asks for, or would have to be pulled. 0 or less: they fit.
double misfit(Round &round) {
    const Vec3 change = sumOfImpulses(round);
    double worst = -INFINITY;
    for (const Hit &hit : round) {
        worst = std::max({worst, hit.wanted - glm::dot(hit.normal, change), -hit.impulse});
    }
    return worst;
}

/// Subsets of hits with their impulses are tried until one fits; until then the one that misses least is kept.
struct Search {
    Round &round;
    double negligible;
    double least = INFINITY;
    Round best{};

    bool fits(std::initializer_list<std::pair<Hit *, double>> pushed) {
        for (Hit &hit : round) hit.impulse = 0.0;
        for (const auto &[hit, impulse] : pushed) hit->impulse = impulse;
        const double missed = misfit(round);
        if (missed < least) {
            least = missed;
            best = round;
        }
        return missed <= negligible;
    }
};

bool fitsOne(Search &search) {
    return std::any_of(search.round.begin(), search.round.end(), [&](Hit &hit) {
        return search.fits({{&hit, hit.wanted}});
    });
}

bool fitsTwo(Search &search) {
    for (Hit &a : search.round) {
        for (Hit *b = &a + 1; b < search.round.end(); ++b) {
            const double cosine = glm::dot(a.normal, b->normal);
            const Vec3 axis = glm::cross(a.normal, b->normal);
            const double determinant = glm::dot(axis, axis); // 1 - cosine^2 without cancellation
            if (determinant == 0.0) continue;
            const double first = (a.wanted - cosine * b->wanted) / determinant;
            const double second = (b->wanted - cosine * a.wanted) / determinant;
            if (search.fits({{&a, first}, {b, second}})) return true;
        }
    }
    return false;
}

/// Three independent normals determine the change of velocity; its shares along them are the impulses.
bool fitsThree(Search &search, Hit &a, Hit &b, Hit &c) {
    const Vec3 bc = glm::cross(b.normal, c.normal);
    const Vec3 ca = glm::cross(c.normal, a.normal);
    const Vec3 ab = glm::cross(a.normal, b.normal);
    const double volume = glm::dot(a.normal, bc);
    if (volume == 0.0) return false;
    const Vec3 change = (a.wanted * bc + b.wanted * ca + c.wanted * ab) / volume;
    return search.fits({{&a, glm::dot(change, bc) / volume},
                        {&b, glm::dot(change, ca) / volume},
                        {&c, glm::dot(change, ab) / volume}});
}

bool fitsThree(Search &search) {
    for (Hit &a : search.round) {
        for (Hit *b = &a + 1; b < search.round.end(); ++b) {
            for (Hit *c = b + 1; c < search.round.end(); ++c) {
                if (fitsThree(search, a, *b, *c)) return true;
            }
        }
    }
    return false;
}

/// For nearly parallel or opposite normals, where rounding keeps every subset from fitting.
void sweepNormals(Round &round, double negligible) {
    for (Hit &hit : round) hit.impulse = 0.0;
    Vec3 change(0.0);
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
        double largest = 0.0;
        for (Hit &hit : round) {
            const double impulse = std::max(0.0, hit.impulse + hit.wanted - glm::dot(hit.normal, change));
            change += (impulse - hit.impulse) * hit.normal;
            largest = std::max(largest, std::abs(impulse - hit.impulse));
            hit.impulse = impulse;
        }
        if (largest <= negligible) return;
    }
}

/// NORMAL: the least impulses that give every hit what it asks for, a linear complementarity problem.
void pushApart(Round &round, Motion &motion, double negligible) {
    Search search{round, negligible};
    if (!fitsOne(search) && !fitsTwo(search) && !fitsThree(search)) {
        sweepNormals(round, negligible);
        if (search.least < misfit(round)) round = search.best;
    }
    for (Hit &hit : round) hit.impulse = std::max(0.0, hit.impulse);
    motion.velocity += sumOfImpulses(round);
}

/// FRICTION: of all impulses within the cones those that leave the least energy.
void rub(Round &round, double radius, Motion &motion) {
    std::array<FrictionDisc, Contacts::kMost> discs;
    uint32_t count = 0;
    for (const Hit &hit : round) {
        const double most = hit.friction * hit.impulse;
        if (most > 0.0) discs[count++] = {hit.normal, most, Vec3(0.0)};
    }
    minimiseSlipEnergy({discs.data(), count}, radius, motion);
}

Round approaching(const Contacts &contacts, const Motion &motion, double negligible) {
    Round round;
    for (uint32_t i = 0; i < contacts.count(); ++i) {
        const Contact &contact = contacts[i];
        const double speed = glm::dot(motion.velocity, contact.normal);
        if (speed >= -negligible) continue;
        round.hits[round.count++] = {i, contact.normal, -(1.0 + contact.restitution) * speed, contact.friction};
    }
    return round;
}

/// After the last round: what still approaches stops, model.md 13.2.
void stopApproach(const Contacts &contacts, Motion &motion, double negligible) {
    Round all;
    for (uint32_t i = 0; i < contacts.count(); ++i) {
        const Vec3 &normal = contacts[i].normal;
        all.hits[all.count++] = {i, normal, -glm::dot(motion.velocity, normal), 0.0};
    }
    pushApart(all, motion, negligible);
}

Impacts resolveInThisOrder(const Contacts &contacts, double radius, Motion &motion) {
    Impacts impacts;
    const double negligible = negligibleSpeed(motion, radius);
    double energy = kineticEnergy(motion, radius);
    const auto lost = [&] {
        const double before = std::exchange(energy, kineticEnergy(motion, radius));
        return before - energy;
    };
    for (;; ++impacts.rounds) {
        Round round = approaching(contacts, motion, negligible);
        if (round.count == 0) return impacts;
        for (const Hit &hit : round) {
            double &approach = impacts.approach[hit.contact];
            if (approach == 0.0) approach = glm::dot(motion.velocity, hit.normal);
        }
        if (impacts.rounds == kMostRounds) break;
        pushApart(round, motion, negligible);
        impacts.lostNormal += lost();
        rub(round, radius, motion);
        impacts.lostSlip += lost();
    }
    stopApproach(contacts, motion, negligible);
    impacts.lostNormal += lost();
    return impacts;
}

} // namespace

Impacts resolveImpacts(const Contacts &contacts, double radius, Motion &motion) {
    const Motion before = motion;
    Impacts impacts = resolveInThisOrder(contacts, radius, motion);
    if (impacts.rounds == 0 || contacts.count() < 2) return impacts;
    // Contacts that nothing tells apart: the mean of both orders prefers none.
    Contacts reversed = contacts;
    if (!reversed.reverseTies()) return impacts;
    Motion other = before;
    resolveInThisOrder(reversed, radius, other);
    motion.velocity = 0.5 * (motion.velocity + other.velocity);
    motion.spin = 0.5 * (motion.spin + other.spin);
    return impacts;
}

} // namespace phys
