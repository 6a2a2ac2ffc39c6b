// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/parameter_sets.h"

#include "core/setup/lines.h"
#include "core/setup/numbers.h"
#include "core/setup/tables.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>

namespace inspector {

namespace {

const QByteArray kMark = "physics-parameters";
constexpr int kVersion = 1;

struct Sets {
    Q_DECLARE_TR_FUNCTIONS(Sets)
};

/// Walls and floor are of the same material.
struct Material {
    double restitution;
    double rolling_friction;
    double sliding_friction;
};

ParameterSet setOf(const QString &name, const Material &material, const QString &about) {
    return {name,
            about,
            {{QStringLiteral("restitution_wall"), material.restitution},
             {QStringLiteral("restitution_floor"), material.restitution},
             {QStringLiteral("rolling_friction"), material.rolling_friction},
             {QStringLiteral("sliding_friction"), material.sliding_friction},
             {QStringLiteral("wall_friction"), material.sliding_friction}}};
}

} // namespace

/// The inspector's README.md also lists the figures and their sources.
const std::vector<ParameterSet> &knownSets() {
    static const std::vector<ParameterSet> sets{
        setOf(
            Sets::tr("Steel on wood"), {0.5, 0.002, 0.3},
            Sets::tr("Restitution 0.5: steel ball bearings give 0.6 on a hard floor (The Physics Factbook), less on "
                     "wood. Rolling friction 0.002, a guess: steel on hard surfaces was measured down to 0.0001, more "
                     "with roughness, speed and a smaller radius (R. Cross, Coulomb's law for rolling friction, Am. J. "
                     "Phys. 84, 2016). Sliding friction 0.3: metal on wood (S. A. Hill, Coefficients of friction).")),
        setOf(Sets::tr("Glass on wood"), {0.65, 0.001, 0.3},
              Sets::tr("Restitution 0.65: a glass marble on a hard floor gives 0.66 (The Physics Factbook). Rolling "
                       "friction 0.001, a guess: down to 0.0001 for hard balls on hard surfaces (R. Cross, Am. J. "
                       "Phys. 84, 2016). Sliding friction 0.3: as metal on wood; no figure for glass was found.")),
        setOf(Sets::tr("Rubber on wood"), {0.8, 0.02, 0.7},
              Sets::tr("Restitution 0.8: a ball of rubber bands on a hard floor gives 0.83 (The Physics Factbook). "
                       "Rolling friction 0.02, a guess: soft balls lose much more than hard ones (R. Cross, "
                       "Measurements of rolling friction with a stringless pendulum), tyres on a hard road 0.008 "
                       "(Moyer, in Marks' Handbook). Sliding friction 0.7: shoes on wood (S. A. Hill).")),
        setOf(Sets::tr("Steel on ice"), {0.6, 0.001, 0.02},
              Sets::tr("Sliding friction 0.02: steel on ice (S. A. Hill, Coefficients of friction). Restitution 0.6 "
                       "and rolling friction 0.001 are guesses, as of steel on another hard floor; what has been "
                       "measured on ice depends much on speed and temperature (Güttler and others, arXiv:1204.0001).")),
    };
    return sets;
}

ParameterSet presentSet(const QString &name, const Parameters &parameters) {
    return {name, {}, sharedValues(parameters, parameters)};
}

std::vector<Setting> valuesFor(const Parameters &parameters, const ParameterSet &set) {
    std::vector<Setting> values;
    std::copy_if(set.values.begin(), set.values.end(), std::back_inserter(values),
                 [&](const Setting &setting) { return parameters.indexOf(setting.id) >= 0; });
    return values;
}

QByteArray setText(const ParameterSet &set) {
    QByteArray text = kMark + ' ' + QByteArray::number(kVersion) + "\nname " + oneLine(set.name).toUtf8() + '\n';
    for (const Setting &setting : set.values)
        text += "set " + setting.id.toUtf8() + ' ' + exactText(setting.value) + '\n';
    return text;
}

std::optional<ParameterSet> readSet(const QByteArray &text, const QString &file, QString *error) {
    ParameterSet set;
    int number = 0;
    const auto fail = [&](const QString &expected, const QByteArray &found) {
        const QString line = QStringLiteral("%1:%2: expected %3, found %4");
        if (error) *error = line.arg(file).arg(number).arg(expected, foundText(QString::fromUtf8(found)));
        return std::nullopt;
    };
    for (const QByteArray &line : text.split('\n')) {
        ++number;
        const QByteArray words = line.simplified();
        const QByteArray mark = kMark + ' ' + QByteArray::number(kVersion);
        if (number == 1 && words == "\xef\xbb\xbf" + mark) {
            if (error)
                *error = QStringLiteral("%1:1: expected %2, found a byte order mark (BOM) before it; save the file "
                                        "without")
                             .arg(file, quoted(QString::fromUtf8(mark)));
            return std::nullopt;
        }
        if (number == 1 && words != mark) return fail(quoted(QString::fromUtf8(mark)), words);
        if (number == 1 || words.isEmpty() || words.startsWith('#')) continue;
        const QList<QByteArray> fields = words.split(' ');
        if (fields[0] == "name" && fields.size() > 1) {
            set.name = QString::fromUtf8(words.mid(5));
            continue;
        }
        if (fields[0] != "set" || fields.size() != 3) return fail(QStringLiteral("'set PARAMETER NUMBER'"), words);
        const NumberReading value = readNumber(QString::fromUtf8(fields[2]), {});
        if (!value.value) {
            if (error) *error = QStringLiteral("%1:%2: %3").arg(file).arg(number).arg(value.problem);
            return std::nullopt;
        }
        const QString id = QString::fromUtf8(fields[1]);
        const bool isTwice =
            std::any_of(set.values.begin(), set.values.end(), [&](const Setting &other) { return other.id == id; });
        if (isTwice) return fail(QStringLiteral("each parameter once"), words);
        set.values.push_back({id, *value.value});
    }
    return set;
}

} // namespace inspector
