// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/engine.h"
#include "core/recording/recording.h"
#include "core/setup/files.h"
#include "core/setup/lines.h"
#include "core/setup/tables.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace inspector {

namespace {

/// A malformed line: what was expected, what was found.
struct WrongLine {
    QString reason;
};

[[noreturn]] void fail(const QString &expected, const QByteArray &found) {
    throw WrongLine{QStringLiteral("expected %1, found %2").arg(expected, foundText(decodePath(found.left(60))))};
}

template<class Number, class... Base>
std::optional<Number> numberFrom(const QByteArray &text, Base... base) {
    Number number{};
    const char *end = text.constData() + text.size();
    const auto result = std::from_chars(text.constData(), end, number, base...);
    if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
    return number;
}

double finite(const QByteArray &text) {
    const std::optional<double> number = numberFrom<double>(text);
    if (!number || !std::isfinite(*number)) fail(QStringLiteral("a finite number"), text);
    return *number;
}

uint64_t whole(const QByteArray &text) {
    const std::optional<uint64_t> number = numberFrom<uint64_t>(text);
    if (!number) fail(QStringLiteral("a whole number"), text);
    return *number;
}

uint64_t hash(const QByteArray &text) {
    const std::optional<uint64_t> number = numberFrom<uint64_t>(text, 16);
    if (!number || text.size() != 16) fail(QStringLiteral("a hash of 16 hexadecimal digits"), text);
    return *number;
}

/// Throws if no ball can have this state, which is found by a step of dt 0 on an empty floor.
void checkState(const phys_state &state) {
    phys_scene_desc nothing;
    phys_params params;
    phys_scene_desc_init(&nothing, sizeof nothing);
    phys_params_init(&params, sizeof params);
    const Scene scene = makeScene(nothing, nullptr);
    const Stepper stepper = makeStepper(nullptr, PHYS_STEPPER_DEFAULT, scene, nullptr);
    phys_state same;
    phys_error failure;
    if (!stepper || phys_step(stepper.get(), &params, 0.0, &state, &same, nullptr, &failure) != PHYS_OK)
        throw WrongLine{stepper ? QString::fromUtf8(failure.text) : QStringLiteral("out of memory")};
}

/// Parses the lines one by one.
class Reader {
public:
    explicit Reader(const Registry &registry)
        : m_registry(registry) {}

    void read(const QByteArray &line);
    Recording takeRecording() { return std::move(m_recording); }

private:
    struct Rule {
        const char *word;
        int fields; ///< number of fields after the keyword; -1: the rest of the line is one
        const char *expected;
        void (Reader::*read)(const QByteArrayList &fields);
    };
    static const std::array<Rule, 11> kRules;

    void readMark(const QByteArray &line);
    void readWord(const QByteArray &line);
    void readProgram(const QByteArrayList &fields) { m_recording.program = QString::fromUtf8(fields[0]); }
    void readLibrary(const QByteArrayList &fields) { m_recording.library = QString::fromUtf8(fields[0]); }
    void readLevel(const QByteArrayList &fields);
    void readStepper(const QByteArrayList &fields);
    void readDt(const QByteArrayList &fields);
    void readSet(const QByteArrayList &fields);
    void readOptions(const QByteArrayList &fields);
    void readBoard(const QByteArrayList &fields);
    void readState(const QByteArrayList &fields);
    void readFailure(const QByteArrayList &fields);
    void readEnd(const QByteArrayList &) { m_recording.isWhole = true; }
    Segment &segment();
    void checkConditions() const;

    const Registry &m_registry;
    Recording m_recording;
    Conditions m_conditions;
    phys_stepper_info m_stepper{};
    std::optional<phys_state> m_from;
    int m_line = 0;
    int m_mazeLine = 0;
    int m_stepperLine = 0;
    bool m_isOpen = false;    ///< the last segment can be continued
    bool m_needsState = true; ///< a `state` line must follow a `level` line
    bool m_needsOptions = true;
    bool m_needsBoard = true;
};

const std::array<Reader::Rule, 11> Reader::kRules{{
    {"program", -1, "'program NAME VERSION'", &Reader::readProgram},
    {"library", 1, "'library VERSION'", &Reader::readLibrary},
    {"level", -1, "'level HASH FILE'", &Reader::readLevel},
    {"stepper", -1, "'stepper ID VERSION'", &Reader::readStepper},
    {"dt", 1, "'dt SECONDS'", &Reader::readDt},
    {"set", 2, "'set PARAMETER VALUE'", &Reader::readSet},
    {"options", 1, "'options BITS'", &Reader::readOptions},
    {"board", 6, "'board' and 6 numbers", &Reader::readBoard},
    {"state", 16, "'state' and 16 numbers", &Reader::readState},
    {"failed", -1, "'failed REASON'", &Reader::readFailure},
    {"end", 0, "'end'", &Reader::readEnd},
}};

void Reader::read(const QByteArray &line) {
    ++m_line;
    if (line.contains('\0')) fail(QStringLiteral("text"), line);
    if (m_line == 1) return readMark(line);
    if (line.startsWith('#') || line.isEmpty()) return;
    if (m_recording.isWhole) fail(QStringLiteral("nothing after 'end'"), line);
    const bool isHash = line.size() == 16 && !line.contains(' ');
    if (isHash)
        segment().hashes.push_back(hash(line));
    else
        readWord(line);
}

void Reader::readMark(const QByteArray &line) {
    const QByteArrayList words = line.split(' ');
    if (words[0] != kRecordingMark) fail(QStringLiteral("a recording: '%1 VERSION'").arg(kRecordingMark), line);
    if (words.size() != 2 || words[1] != QByteArray::number(kRecordingVersion))
        fail(QStringLiteral("version %1 of the format").arg(kRecordingVersion), words.mid(1).join(' '));
}

void Reader::readWord(const QByteArray &line) {
    const qsizetype end = line.indexOf(' ');
    const QByteArray word = end < 0 ? line : line.left(end);
    const auto *rule = std::find_if(kRules.begin(), kRules.end(), [&](const Rule &each) { return word == each.word; });
    if (rule == kRules.end()) fail(QStringLiteral("the hash of a step or a word as 'set'"), line);
    const QByteArray rest = end < 0 ? QByteArray() : line.mid(end + 1);
    const QByteArrayList fields = rule->fields < 0 ? QByteArrayList{rest} : rest.split(' ');
    const bool isRight = rule->fields == 0 ? end < 0 : end >= 0 && !fields.contains(QByteArray());
    if (!isRight || (rule->fields > 0 && fields.size() != rule->fields)) fail(QString::fromUtf8(rule->expected), line);
    (this->*rule->read)(fields);
    const bool isInput = rule->read != &Reader::readFailure;
    if (isInput) m_isOpen = false;
}

/// The inverse of pathText().
QString pathOf(const QByteArray &text) {
    QByteArray bytes;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const QByteArray escape = text.mid(i, 3);
        const bool isEscape = escape == "%0A" || escape == "%0D" || escape == "%25";
        bytes += isEscape ? QByteArray::fromHex(escape.mid(1)) : text.mid(i, 1);
        if (isEscape) i += 2;
    }
    return decodePath(bytes);
}

void Reader::readLevel(const QByteArrayList &fields) {
    const qsizetype end = fields[0].indexOf(' ');
    if (end < 0 || end + 1 == fields[0].size()) fail(QStringLiteral("'level HASH FILE'"), "level " + fields[0]);
    m_conditions.maze = {pathOf(fields[0].mid(end + 1)), hash(fields[0].left(end))};
    m_mazeLine = m_line;
    m_from.reset();
    m_needsState = true;
}

void Reader::readStepper(const QByteArrayList &fields) {
    const qsizetype end = fields[0].indexOf(' ');
    if (end < 0 || end + 1 == fields[0].size()) fail(QStringLiteral("'stepper ID VERSION'"), "stepper " + fields[0]);
    const StepperSource source{fields[0].left(end), fields[0].mid(end + 1)};
    phys_error failure;
    if (phys_registry_find(m_registry.get(), source.id.constData(), &m_stepper, &failure) != PHYS_OK)
        throw WrongLine{QString::fromUtf8(failure.text) + QStringLiteral("; --plugin loads a plugin's steppers")};
    m_conditions.stepper = source;
    m_stepperLine = m_line;
    phys_stepper_info_init_params(&m_stepper, &m_conditions.inputs.params);
}

void Reader::readDt(const QByteArrayList &fields) {
    const double dt = finite(fields[0]);
    if (!(dt >= Engine::kSmallestDt && dt <= Engine::kLargestDt))
        fail(QStringLiteral("dt from %1 to %2 s").arg(Engine::kSmallestDt).arg(Engine::kLargestDt), fields[0]);
    m_conditions.dt = dt;
}

void Reader::readSet(const QByteArrayList &fields) {
    if (!m_stepper.id) fail(QStringLiteral("'stepper' before its parameters"), "set " + fields[0]);
    const std::vector<const phys_param_row *> rows = recordedRows(m_stepper);
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto *each) { return fields[0] == each->id; });
    if (row == rows.end())
        fail(QStringLiteral("a parameter of stepper %1").arg(QString::fromUtf8(m_stepper.id)), fields[0]);
    phys_error failure;
    if (phys_param_set(&m_conditions.inputs.params, *row, finite(fields[1]), &failure) != PHYS_OK)
        throw WrongLine{QString::fromUtf8(failure.text)};
}

void Reader::readOptions(const QByteArrayList &fields) {
    const uint64_t options = whole(fields[0]);
    if (options & ~uint64_t(PHYS_OPTIONS)) fail(QStringLiteral("options from 0 to %1").arg(PHYS_OPTIONS), fields[0]);
    m_conditions.inputs.params.options = uint32_t(options);
    m_needsOptions = false;
}

void Reader::readBoard(const QByteArrayList &fields) {
    std::array<double, 6> numbers{};
    std::transform(fields.begin(), fields.end(), numbers.begin(), finite);
    phys_vec3 ignored; // the recorded one counts: another C library may round it differently
    if (phys_gravity_from_tilt(numbers[0], numbers[1], numbers[2], &ignored) != PHYS_OK)
        fail(QStringLiteral("two tilts within pi/2 and a strength >= 0"), "board " + fields.join(' '));
    Inputs &inputs = m_conditions.inputs;
    inputs.tilt = {numbers[0], numbers[1]};
    inputs.gravity = numbers[2];
    inputs.params.gravity = {numbers[3], numbers[4], numbers[5]};
    m_needsBoard = false;
}

void Reader::readState(const QByteArrayList &fields) {
    phys_state state{};
    state.time = finite(fields[0]);
    state.step = whole(fields[1]);
    const auto vector = [&](int place) {
        return phys_vec3{finite(fields[place]), finite(fields[place + 1]), finite(fields[place + 2])};
    };
    state.position = vector(2);
    state.velocity = vector(5);
    state.spin = vector(8);
    for (int i = 0; i < 4; ++i) state.orientation[i] = finite(fields[11 + i]);
    state.flags = whole(fields[15]);
    checkState(state);
    m_from = state;
    m_needsState = false;
}

void Reader::readFailure(const QByteArrayList &fields) {
    Segment &last = segment();
    last.failure = QString::fromUtf8(fields[0]);
    m_isOpen = false;
}

/// The segment of the next step.
Segment &Reader::segment() {
    if (m_isOpen) return m_recording.segments.back();
    checkConditions();
    m_recording.segments.push_back({m_conditions, m_from, {}, {}, m_mazeLine, m_stepperLine});
    m_from.reset();
    m_isOpen = true;
    return m_recording.segments.back();
}

void Reader::checkConditions() const {
    const auto missing = [](const char *word) {
        throw WrongLine{QStringLiteral("expected '%1' before the first step, found a step").arg(word)};
    };
    if (m_conditions.maze.path.isEmpty()) missing("level");
    if (!m_stepper.id) missing("stepper");
    if (m_conditions.dt <= 0.0) missing("dt");
    if (m_needsOptions) missing("options");
    if (m_needsBoard) missing("board");
    if (m_needsState) missing("state");
    phys_error failure;
    if (phys_params_check(&m_conditions.inputs.params, &failure) != PHYS_OK)
        throw WrongLine{QString::fromUtf8(failure.text)};
}

std::optional<Recording> refuse(QString *error, int line, const QString &reason) {
    if (error) *error = QStringLiteral("%1: %2").arg(line).arg(reason);
    return std::nullopt;
}

} // namespace

std::optional<Recording> parseRecording(const QByteArray &text, const Registry &registry, QString *error) {
    Reader reader(registry);
    qsizetype begin = 0;
    for (int number = 1;; ++number) {
        const qsizetype end = text.indexOf('\n', begin);
        if (end < 0 && number > 1) break; // an incomplete line from an interrupted program
        QByteArray line = text.mid(begin, end < 0 ? -1 : end - begin);
        while (line.endsWith('\r')) line.chop(1); // line ends converted by mail or editors
        try {
            reader.read(line);
        } catch (const WrongLine &wrong) {
            return refuse(error, number, wrong.reason);
        }
        if (end < 0) break;
        begin = end + 1;
    }
    return reader.takeRecording();
}

std::optional<Recording> readRecording(const QString &path, const Registry &registry, QString *error) {
    constexpr qint64 kLargest = 1000 * kMegabyte; // 16 hours of steps of 1 ms
    const std::optional<QByteArray> text = readFile(path, kLargest, error);
    if (!text) return std::nullopt;
    std::optional<Recording> recording = parseRecording(*text, registry, error);
    if (recording)
        recording->file = path;
    else if (error)
        *error = oneLine(path) + QLatin1Char(':') + *error;
    return recording;
}

bool isRecordingFile(const QString &path) {
    const QByteArray mark(kRecordingMark);
    return beginningOf(path, mark.size()) == mark;
}

} // namespace inspector
