// SPDX-License-Identifier: MIT
#include "peers/front.h"

#include <algorithm>

namespace bench {

namespace {

bool beats(const Trial &a, const Trial &b) {
    return a.secondsPerSimulated <= b.secondsPerSimulated && a.medianLargest() <= b.medianLargest();
}

std::vector<const Trial *> answeredOf(const std::vector<Trial> &trials, const std::string &group) {
    std::vector<const Trial *> answered = trialsOf(trials, group);
    std::erase_if(answered, [](const Trial *trial) { return !trial->answered(); });
    return answered;
}

} // namespace

std::vector<const Trial *> trialsOf(const std::vector<Trial> &trials, const std::string &group) {
    std::vector<const Trial *> found;
    for (const Trial &trial : trials)
        if (trial.group == group) found.push_back(&trial);
    return found;
}

std::vector<const Trial *> paretoFront(const std::vector<Trial> &trials, const std::string &group) {
    std::vector<const Trial *> all = answeredOf(trials, group);
    std::stable_sort(all.begin(), all.end(),
                     [](const Trial *a, const Trial *b) { return a->secondsPerSimulated < b->secondsPerSimulated; });
    std::vector<const Trial *> front;
    for (const Trial *trial : all)
        if (front.empty() || trial->medianLargest() < front.back()->medianLargest()) front.push_back(trial);
    return front;
}

const Trial *cheapestUnder(const std::vector<Trial> &trials, const std::string &group, double bound, Side side) {
    const Trial *cheapest = nullptr;
    for (const Trial *trial : answeredOf(trials, group)) {
        if (trial->ours != (side == Side::Ours) || trial->worstLargest() > bound) continue;
        if (!cheapest || trial->secondsPerSimulated < cheapest->secondsPerSimulated) cheapest = trial;
    }
    return cheapest;
}

std::vector<const Trial *> unbeatenPeers(const std::vector<Trial> &trials, const std::string &group) {
    const std::vector<const Trial *> all = answeredOf(trials, group);
    std::vector<const Trial *> unbeaten;
    for (const Trial *peer : all) {
        if (peer->ours) continue;
        const bool isBeaten =
            std::any_of(all.begin(), all.end(), [&](const Trial *ours) { return ours->ours && beats(*ours, *peer); });
        if (!isBeaten) unbeaten.push_back(peer);
    }
    return unbeaten;
}

} // namespace bench
