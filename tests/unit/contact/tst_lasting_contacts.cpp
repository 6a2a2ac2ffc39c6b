// SPDX-License-Identifier: MIT
// Coulomb's law of all lasting contacts over a substep (model.md 13.5), in cases where sweeps over the contacts
// converge slowly or not at all.
#include "contact/lasting.h"

#include <QtTest>

namespace {

using phys::Lasting;
using phys::LastingContacts;
using phys::Motion;
using phys::Vec3;
using phys::Work;

constexpr double kLastingRadius = 0.03125;
constexpr double kRounding = 1e-13;

const Vec3 kUp(0.0, 0.0, 1.0);

Lasting contact(const Vec3 &normal, double friction, double slow = 0.0) {
    Lasting contact{};
    contact.lever = contact.limit = normal;
    contact.slow = slow;
    contact.friction = friction;
    contact.isTop = normal == kUp;
    contact.load = -1.0;
    return contact;
}

/// Spins are given as surface speeds.
Motion motion(const Vec3 &velocity, const Vec3 &surface) { return {velocity, surface / kLastingRadius}; }

Vec3 slip(const Motion &motion, const Lasting &contact) { return phys::slipAt(motion, contact.limit, kLastingRadius); }

/// No contact is approached, none pulls, and friction is within its cone, against the slip if there is one.
bool obeysCoulomb(const LastingContacts &contacts, const Motion &motion) {
    return std::all_of(contacts.begin(), contacts.end(), [&](const Lasting &contact) {
        const double speed = glm::dot(motion.velocity, contact.limit) - contact.slow;
        if (speed < -kRounding || contact.reaction < 0.0) return false;
        if (contact.reaction > 0.0 && speed > kRounding) return false;
        const double most = contact.friction * contact.reaction;
        const Vec3 sliding = slip(motion, contact);
        if (glm::length(contact.rubbing) > most + kRounding) return false;
        const double size = glm::length(sliding);
        return size < kRounding || glm::length(contact.rubbing + most / size * sliding) < 1e-9;
    });
}

double pressure(const LastingContacts &contacts) {
    double sum = 0.0;
    for (const Lasting &contact : contacts) sum += contact.reaction;
    return sum;
}

} // namespace

class LastingContactsTest : public QObject {
    Q_OBJECT

private slots:
    void aGrooveOfFloorAndEdgeStopsABallThatSlipsInIt();
    void aWedgeCarriesASpinningBallByTheLeastPressure();
    void theRoughestWallAndEdgeRub();
    void whatSticksRollsOnToAGapThatCloses();
    void whatFindsAnAnswerIsCounted();
};

void LastingContactsTest::aGrooveOfFloorAndEdgeStopsABallThatSlipsInIt() {
    Work work;
    LastingContacts contacts(kLastingRadius, work);
    contacts.add(contact(kUp, 1.0));
    contacts.add(contact({-0.9457302746909354, 0.0, 0.3249526850681613}, 1.0));
    Motion moved = motion({1.2276678411942e-3, 0.021493566551782, -5.487252984322e-3},
                          {-0.020272411553722, 1.116785357763e-3, -0.019860274015771});
    contacts.solve(0.5, moved);
    QVERIFY(obeysCoulomb(contacts, moved));
    QVERIFY(moved.velocity.y < 0.0214);
}

void LastingContactsTest::aWedgeCarriesASpinningBallByTheLeastPressure() {
    Work work;
    LastingContacts contacts(kLastingRadius, work);
    contacts.add(contact({0.99999, -0.004472124774662, 0.0}, 0.5));
    contacts.add(contact({-0.99999, -0.004472124774662, 0.0}, 0.5));
    contacts.add(contact(kUp, 1.0));
    Motion moved = motion({-1.2e-5, 3e-5, -6.6e-3}, {-0.093, 0.0, 0.0});
    contacts.solve(0.0, moved);
    QVERIFY(obeysCoulomb(contacts, moved));
    // Jammed by the spin that floor and edges make, which they would press a thousand times as much.
    QVERIFY(pressure(contacts) < 0.1);
}

void LastingContactsTest::theRoughestWallAndEdgeRub() {
    Work work;
    LastingContacts contacts(kLastingRadius, work);
    contacts.add(contact({0.0, 1.0, 0.0}, 1e6));
    contacts.add(contact({0.43973312472422432, 0.0, 0.89812848692170411}, 1e6, -1.37e-4));
    Motion moved = motion({0.7289142120866994, -2.5879591329422e-4, -0.3585167864322523},
                          {-0.356222613146636, 0.5082645464579559, -0.728563752011236});
    contacts.solve(0.0, moved);
    QVERIFY(glm::length(slip(moved, contacts[0])) < kRounding);
    QVERIFY(glm::length(slip(moved, contacts[1])) < 1e-3);
}

void LastingContactsTest::whatSticksRollsOnToAGapThatCloses() {
    Work work;
    LastingContacts contacts(kLastingRadius, work);
    contacts.add(contact(kUp, 0.1));
    contacts.add(contact({0.98270998277775212, -0.18515153185688177, 0.0}, 0.5, -3e-8));
    Motion moved = motion({6.722236873037e-5, 1.146698991461e-3, -2.801433275824e-3},
                          {-1.051802562445e-3, 9.241448843725e-5, 1.064962166477e-3});
    contacts.solve(0.0, moved);
    QVERIFY(std::abs(glm::dot(moved.velocity, contacts[1].limit) + 3e-8) < kRounding);
    QVERIFY(std::abs(moved.velocity.z) < kRounding);
    QVERIFY(glm::length(slip(moved, contacts[0])) < kRounding);
    QVERIFY(glm::length(slip(moved, contacts[1])) < 1e-6);
}

void LastingContactsTest::whatFindsAnAnswerIsCounted() {
    Work work(5 * Work::kDisc);
    LastingContacts contacts(kLastingRadius, work);
    contacts.add(contact({0.99999, -0.004472124774662, 0.0}, 0.5));
    contacts.add(contact({-0.99999, -0.004472124774662, 0.0}, 0.5));
    Motion moved = motion({-1.2e-5, 3e-3, -6.6e-3}, {-0.093, 0.0, 0.0});
    contacts.solve(0.0, moved);
    QVERIFY(work.isTooMuch());
}

QTEST_GUILESS_MAIN(LastingContactsTest)
#include "tst_lasting_contacts.moc"
