// SPDX-License-Identifier: MIT
// The pushes of least sum that reach given bounds (model.md 13.2), against closed forms.
#include "contact/least_push.h"

#include <QtTest>

#include <vector>

namespace {

using phys::leastPush;
using phys::Push;
using phys::Vec3;
using phys::Work;

constexpr double kPushRounding = 1e-15; // what leastPush is told to ignore
constexpr double kPushError = 4e-15;    // several of those, and the tests' own rounding

/// Unit, tilted by `angle` from straight up towards `heading`, both in rad.
Vec3 sloped(double angle, double heading = 0.0) {
    return {std::sin(angle) * std::cos(heading), std::sin(angle) * std::sin(heading), std::cos(angle)};
}

/// A push that the whole sum `all` just satisfies.
Push bounding(const Vec3 &normal, const Vec3 &all) { return {normal, glm::dot(normal, all)}; }

Vec3 pushedBy(std::vector<Push> &pushes) {
    Work work;
    return leastPush(pushes, kPushRounding, work);
}

double totalAmount(const std::vector<Push> &pushes) {
    double sum = 0.0;
    for (const Push &push : pushes) sum += push.amount;
    return sum;
}

} // namespace

class LeastPushTest : public QObject {
    Q_OBJECT

private slots:
    void onePushReachesItsBound();
    void aBoundThatIsExceededNeedsNoPush();
    void twoSidesOfAChuteShareTheLoad();
    void threeNormalsReachAnySum();
    void ofTwoSolutionsTheOneThatPushesLeastIsTaken();
    void threeThatPushLessThanTwoAreTaken();
    void aBoundMayBeAcrossAnotherDirection();
    void nearlyParallelNormalsShareTheLoad();
    void oppositeBoundsHaveNoSolutionOfAFew();
};

void LeastPushTest::onePushReachesItsBound() {
    std::vector<Push> pushes{{sloped(0.4), 2.0}};
    QVERIFY(glm::length(pushedBy(pushes) - 2.0 * sloped(0.4)) < kPushError);
}

void LeastPushTest::aBoundThatIsExceededNeedsNoPush() {
    std::vector<Push> pushes{{sloped(0.0), 1.0}, {sloped(1.0), 0.5}}; // cos 1 = 0.54
    QVERIFY(glm::length(pushedBy(pushes) - Vec3(0.0, 0.0, 1.0)) < kPushError);
    QCOMPARE(pushes[1].amount, 0.0);
}

/// Each side of a chute of slope a carries 1/(2 cos a) of the load.
void LeastPushTest::twoSidesOfAChuteShareTheLoad() {
    const double slope = 0.7;
    const Vec3 load(0.0, 0.0, 1.0);
    std::vector<Push> pushes{bounding(sloped(slope), load), bounding(sloped(-slope), load)};
    QVERIFY(glm::length(pushedBy(pushes) - load) < kPushError);
    for (const Push &push : pushes) QVERIFY(std::abs(push.amount - 0.5 / std::cos(slope)) < kPushError);
}

void LeastPushTest::threeNormalsReachAnySum() {
    const Vec3 load(0.1, -0.05, 1.0);
    std::vector<Push> pushes;
    for (const double heading : {0.0, 2.0, 4.0}) pushes.push_back(bounding(sloped(0.8, heading), load));
    QVERIFY(glm::length(pushedBy(pushes) - load) < kPushError);
}

void LeastPushTest::ofTwoSolutionsTheOneThatPushesLeastIsTaken() {
    const Vec3 load(0.0, 0.0, 1.0);
    std::vector<Push> pushes;
    for (const double slope : {1.4, -1.4, 0.3, -0.3}) pushes.push_back(bounding(sloped(slope), load));
    QVERIFY(glm::length(pushedBy(pushes) - load) < kPushError);
    QVERIFY(std::abs(totalAmount(pushes) - 1.0 / std::cos(0.3)) < kPushError);
}

void LeastPushTest::threeThatPushLessThanTwoAreTaken() {
    const Vec3 load(0.0, 0.0, 1.0);
    std::vector<Push> pushes{bounding(sloped(1.4), load), bounding(sloped(-1.4), load)};
    for (const double heading : {1.0, 3.0, 5.0}) pushes.push_back(bounding(sloped(0.3, heading), load));
    QVERIFY(glm::length(pushedBy(pushes) - load) < kPushError);
    QVERIFY(std::abs(totalAmount(pushes) - 1.0 / std::cos(0.3)) < kPushError);
}

/// limit . (amount * normal) = wanted, with limit . normal = 1.
void LeastPushTest::aBoundMayBeAcrossAnotherDirection() {
    const Vec3 limits[] = {Vec3(1.0, 0.0, 0.1), Vec3(0.2, 1.0, 0.0)};
    std::vector<Push> pushes{{{1.0, 0.0, 0.0}, 0.3, limits[0]}, {{0.0, 1.0, 0.0}, 0.4, limits[1]}};
    const Vec3 sum = pushedBy(pushes);
    QVERIFY(std::abs(glm::dot(limits[0], sum) - 0.3) < kPushError);
    QVERIFY(std::abs(glm::dot(limits[1], sum) - 0.4) < kPushError);
}

/// The amounts are known to u/angle^2 only, their sum to rounding.
void LeastPushTest::nearlyParallelNormalsShareTheLoad() {
    const Vec3 load(0.0, 0.0, 1.0);
    std::vector<Push> pushes;
    for (const double slope : {1e-4, -1e-4}) pushes.push_back(bounding(sloped(slope), load));
    QVERIFY(glm::length(pushedBy(pushes) - load) < 1e-11);
}

void LeastPushTest::oppositeBoundsHaveNoSolutionOfAFew() {
    Work work;
    std::vector<Push> pushes{{{1.0, 0.0, 0.0}, 1.0}, {{-1.0, 0.0, 0.0}, 1.0}};
    QVERIFY(!phys::leastPushOfFew(pushes, kPushRounding, work));
}

QTEST_GUILESS_MAIN(LeastPushTest)
#include "tst_least_push.moc"
