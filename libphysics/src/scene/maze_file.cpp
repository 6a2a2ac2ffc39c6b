// SPDX-License-Identifier: MIT
#include "scene/maze_file.h"

#include "base/error.h"
#include "base/system.h"

#include <cstdarg>
#include <string_view>

namespace phys {

namespace {

constexpr std::string_view kSpace = " \t";

/// A million boxes with the longest lines need less.
constexpr size_t kMostBytes = 268'435'456;

/// Reads one file; keeps its position and the results so far.
class Reader {
public:
    Reader(const char *name, phys_error *err)
        : m_name(name)
        , m_err(err) {}

    phys_status read(std::string_view text) {
        if (const char *mark = markBefore(text)) return refuse("expected 'physics-maze 1', found %s", mark);
        const char *content = text.empty() ? "a file of size 0" : "no more than comments";
        for (;; ++m_line) { // an empty text is an empty line
            const size_t end = text.find('\n');
            const size_t size = end == std::string_view::npos ? text.size() : end + 1;
            if (const phys_status status = readLine(withoutEnd(text.substr(0, size)))) return status;
            if (size == text.size()) break;
            text.remove_prefix(size);
        }
        if (!m_isMaze) return refuse("expected 'physics-maze 1' as the first line, found %s", content);
        if (!m_hasUnits) return refuse("'units m' is missing");
        if (!m_hasBall) return refuse("'ball RADIUS' is missing");
        if (!m_hasStart) return refuse("'start X Y Z' is missing");
        return PHYS_OK;
    }

    phys_status makeScene(Scene &out) const {
        phys_scene_desc desc{sizeof desc, static_cast<uint32_t>(m_boxes.size()), m_boxes.data(), m_radius, m_start};
        phys_error reason{};
        const phys_status status = phys::makeScene(desc, out, &reason);
        return status ? failIn(m_err, status, m_name, ": %s", reason.text) : PHYS_OK;
    }

private:
    [[PHYS_CHECKED_FORMAT(2, 3)]] phys_status refuse(const char *format, ...) const {
        char text[sizeof phys_error::text];
        va_list arguments;
        va_start(arguments, format);
        writeTextOf(text, sizeof text, format, arguments);
        va_end(arguments);
        return failIn(m_err, PHYS_ERROR_SYNTAX, m_name, ":%u: %s", m_line, text);
    }

    /// What is wrong with the numbers of a line.
    phys_status passOn(phys_status status, const phys_error &reason) const {
        return status ? failIn(m_err, status, m_name, ":%u: %s", m_line, reason.text) : PHYS_OK;
    }

    /// The byte order mark that some editors put before a text; nullptr if there is none.
    static const char *markBefore(std::string_view text) {
        if (text.starts_with("\xef\xbb\xbf")) return "a byte order mark (BOM) before it; save the file without";
        const bool isUtf16 = text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
        return isUtf16 ? "UTF-16; save the file as UTF-8" : nullptr;
    }

    static std::string_view withoutEnd(std::string_view line) {
        if (line.ends_with("\r\n")) return line.substr(0, line.size() - 2);
        return line.ends_with('\n') ? line.substr(0, line.size() - 1) : line;
    }

    phys_status readLine(std::string_view line) {
        if (line.find('\r') != std::string_view::npos)
            return refuse("expected \\n or \\r\\n as the end of the line, found \\r alone");
        line = line.substr(0, line.find('#'));
        const std::string_view key = nextWord(line);
        if (key.empty()) return PHYS_OK;
        if (!m_isMaze) return readVersion(key, line);
        if (key == "units") return readUnits(line);
        if (key == "generator") return PHYS_OK;
        if (key == "ball") return readBall(line);
        if (key == "start") return readStart(line);
        if (key == "box") return readBox(line);
        return refuse("expected units, generator, ball, start or box, found '%.*s'", shown(key), key.data());
    }

    phys_status readVersion(std::string_view key, std::string_view line) {
        const std::string_view version = nextWord(line);
        if (key != "physics-maze") {
            return refuse("expected 'physics-maze 1', found '%.*s'", shown(key), key.data());
        }
        if (version != "1") {
            return refuse("expected version 1, found '%.*s'", shown(version), version.data());
        }
        m_isMaze = true;
        return expectEnd(line);
    }

    phys_status readUnits(std::string_view line) {
        const std::string_view unit = nextWord(line);
        if (unit != "m") return refuse("expected 'units m', found '%.*s'", shown(unit), unit.data());
        m_hasUnits = true;
        return expectEnd(line);
    }

    phys_status readOnce(const char *key, bool &seen, double *numbers, int count, std::string_view line) {
        if (seen) return refuse("'%s' is given twice", key);
        seen = true;
        return readNumbers(key, numbers, count, line);
    }

    phys_status readBall(std::string_view line) {
        if (const phys_status status = readOnce("ball", m_hasBall, &m_radius, 1, line)) return status;
        phys_error reason;
        return passOn(checkRadius(m_radius, &reason), reason);
    }

    phys_status readStart(std::string_view line) {
        if (const phys_status status = readOnce("start", m_hasStart, &m_start.x, 3, line)) return status;
        phys_error reason;
        return passOn(checkStart(m_start, &reason), reason);
    }

    phys_status readBox(std::string_view line) {
        double n[6];
        if (const phys_status status = readNumbers("box", n, 6, line)) return status;
        for (int axis = 0; axis < 3; ++axis) {
            if (n[axis] <= n[axis + 3]) continue;
            return refuse("box: the lower corner's %c = %.17g is above the upper one's %.17g", "xyz"[axis], n[axis],
                          n[axis + 3]);
        }
        m_boxes.push_back({{n[0], n[1], n[2]}, {n[3], n[4], n[5]}});
        phys_error reason;
        return passOn(checkBox(m_boxes.back(), static_cast<uint32_t>(m_boxes.size() - 1), &reason), reason);
    }

    phys_status readNumbers(const char *key, double *numbers, int count, std::string_view line) {
        for (int i = 0; i < count; ++i) {
            const std::string_view word = nextWord(line);
            if (word.empty())
                return refuse("%s: expected %d number%s in m, found %d", key, count, count == 1 ? "" : "s", i);
            if (parseNumber(word, numbers[i])) continue;
            return refuse("%s: expected a number in m, found '%.*s'%s", key, shown(word), word.data(),
                          isBeyondDouble(word) ? ", which is beyond what a number can hold" : "");
        }
        return expectEnd(line);
    }

    phys_status expectEnd(std::string_view line) const {
        const std::string_view rest = nextWord(line);
        if (rest.empty()) return PHYS_OK;
        return refuse("expected the end of the line, found '%.*s'", shown(rest), rest.data());
    }

    static std::string_view nextWord(std::string_view &line) {
        const size_t begin = line.find_first_not_of(kSpace);
        if (begin == std::string_view::npos) return {};
        const size_t end = std::min(line.find_first_of(kSpace, begin), line.size());
        const std::string_view word = line.substr(begin, end - begin);
        line.remove_prefix(end);
        return word;
    }

    /// Largest length of a word in a message.
    static int shown(std::string_view word) { return static_cast<int>(std::min<size_t>(word.size(), 40)); }

    const char *m_name; ///< of the file, for messages
    phys_error *m_err;
    uint32_t m_line = 1;
    bool m_isMaze = false, m_hasUnits = false, m_hasBall = false, m_hasStart = false;
    double m_radius = 0.0;
    phys_vec3 m_start{};
    std::vector<phys_box> m_boxes;
};

/// The whole file, or why it can't be read.
phys_status readFile(const char *path, std::string &out, phys_error *err) {
    const std::string reason = system::readFile(path, kMostBytes, out);
    return reason.empty() ? PHYS_OK : failIn(err, PHYS_ERROR_FILE, path, ": %s", reason.c_str());
}

} // namespace

phys_status parseScene(std::string_view text, const char *name, Scene &out, phys_error *err) {
    Reader reader(name, err);
    if (const phys_status status = reader.read(text)) return status;
    return reader.makeScene(out);
}

phys_status loadScene(const char *path, Scene &out, phys_error *err) {
    if (!*path) return fail(err, PHYS_ERROR_FILE, "path is empty; expected a file's name");
    std::string text;
    if (const phys_status status = readFile(path, text, err)) return status;
    return parseScene(text, path, out, err);
}

} // namespace phys
