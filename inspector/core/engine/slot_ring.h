// SPDX-License-Identifier: GPL-3.0-or-later
// A ring of plain values that one thread writes while any number of threads read: the lock-free protocol of the
// stepping thread's histories (samples, events). Each slot is a sequence lock.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>

namespace inspector {

/// Zero-initialised words whose pages are only allocated when they are touched. Stores are release and loads acquire,
/// so that a reader who sees a new word also sees what was written before it; on x86 and ARM64 this costs nothing
/// extra.
class SharedWords {
public:
    explicit SharedWords(size_t count)
        : m_words(static_cast<uint64_t *>(std::calloc(count, sizeof(uint64_t)))) {
        if (!m_words) throw std::bad_alloc();
    }

    void store(size_t index, uint64_t word) { cell(index).store(word, std::memory_order_release); }
    uint64_t load(size_t index) const { return cell(index).load(std::memory_order_acquire); }

private:
    struct Free {
        void operator()(uint64_t *words) const { std::free(words); }
    };
    std::atomic_ref<uint64_t> cell(size_t index) const { return std::atomic_ref<uint64_t>(m_words.get()[index]); }

    std::unique_ptr<uint64_t[], Free> m_words;
};

/// Values are numbered from 0 and never renumbered; the oldest are overwritten. No side ever blocks: a read returns
/// false for what is gone, not there yet or being written, and never returns a torn value.
template<typename Value>
class SlotRing {
public:
    static constexpr size_t kWords = sizeof(Value) / sizeof(uint64_t);
    static_assert(sizeof(Value) == kWords * sizeof(uint64_t) && std::is_trivially_copyable_v<Value>);

    /// capacity: rounded up to a power of two.
    explicit SlotRing(size_t capacity)
        : m_capacity(std::bit_ceil(capacity))
        , m_words(m_capacity * kSlotWords) {}

    // ---- the writer's side ----

    uint64_t written() const { return m_written; } ///< number of the next value

    void append(const Value &value) {
        write(value);
        publish();
    }
    /// append() in two parts, between which the writer may add what belongs to the value elsewhere.
    void write(const Value &value) {
        m_begun.store(m_written + 1, std::memory_order_relaxed);
        store(m_written, value);
        ++m_written;
    }
    void publish() {
        if (!m_isHeld) m_last.store(m_written, std::memory_order_release);
    }

    /// Overwrites a value that is still there.
    void rewrite(uint64_t number, const Value &value) { store(number, value); }

    /// Discards everything before; numbers continue.
    void clear() {
        m_cleared = m_written;
        ++m_clears;
        if (!m_isHeld) show();
    }

    /// Takes back the values from `number` on: their numbers are given again.
    void truncate(uint64_t number) {
        m_written = std::clamp(number, m_cleared, m_written);
        ++m_truncations;
        if (!m_isHeld) show();
    }

    /// Between hold() and release() readers see the old content; at release() all changes become visible at once.
    void hold() { m_isHeld = true; }
    void release() {
        m_isHeld = false;
        show();
    }
    bool isHeld() const { return m_isHeld; }
    uint64_t cleared() const { return m_cleared; } ///< the first that is still valid
    /// Also reads what is held back.
    bool readOwn(uint64_t number, Value &out) const {
        return number < m_written && m_written - number <= m_capacity && readSlot(number, out);
    }

    // ---- the readers' side: [first(), last()) can be read just now ----

    size_t capacity() const { return m_capacity; }
    uint64_t last() const { return m_last.load(std::memory_order_acquire); }
    uint64_t first() const {
        const uint64_t begun = m_begun.load(std::memory_order_acquire);
        const uint64_t oldest = begun > m_capacity ? begun - m_capacity : 0;
        return std::max(oldest, m_seenCleared.load(std::memory_order_acquire));
    }
    /// How often clear() was called: a reader that sees another number must start over.
    uint64_t generation() const { return m_generation.load(std::memory_order_acquire); }
    /// How often truncate() was called.
    uint64_t truncations() const { return m_seenTruncations.load(std::memory_order_acquire); }
    uint64_t firstOfGeneration() const { return m_seenCleared.load(std::memory_order_acquire); }

    bool read(uint64_t number, Value &out) const {
        return number >= first() && number < last() && readSlot(number, out);
    }

    /// One word of a value, for scans that check first() again afterwards.
    uint64_t word(uint64_t number, size_t index) const { return m_words.load(slotOf(number) + kHead + index); }

private:
    static constexpr size_t kHead = 2; ///< version, odd while the slot is being written; number
    static constexpr size_t kSlotWords = kHead + kWords;

    size_t slotOf(uint64_t number) const { return size_t(number & (m_capacity - 1)) * kSlotWords; }

    bool readSlot(uint64_t number, Value &out) const {
        const size_t slot = slotOf(number);
        const uint64_t version = m_words.load(slot);
        uint64_t words[kWords];
        for (size_t i = 0; i < kWords; ++i) words[i] = m_words.load(slot + kHead + i);
        const uint64_t held = m_words.load(slot + 1);
        if (version % 2 != 0 || m_words.load(slot) != version || held != number) return false;
        std::memcpy(&out, words, sizeof out);
        return true;
    }

    void store(uint64_t number, const Value &value) {
        uint64_t words[kWords];
        std::memcpy(words, &value, sizeof words);
        const size_t slot = slotOf(number);
        const uint64_t version = m_words.load(slot);
        m_words.store(slot, version + 1);
        m_words.store(slot + 1, number);
        for (size_t i = 0; i < kWords; ++i) m_words.store(slot + kHead + i, words[i]);
        m_words.store(slot, version + 2);
    }

    /// Removals are published before additions: values from before and after a clear() are never seen together.
    void show() {
        m_seenCleared.store(m_cleared, std::memory_order_release);
        m_last.store(m_written, std::memory_order_release);
        m_seenTruncations.store(m_truncations, std::memory_order_release);
        m_generation.store(m_clears, std::memory_order_release);
    }

    size_t m_capacity;
    SharedWords m_words; ///< [slot][kSlotWords]
    /// The writer's state, visible to readers after release().
    uint64_t m_written = 0;
    uint64_t m_cleared = 0; ///< m_written at the last clear()
    uint64_t m_clears = 0;
    uint64_t m_truncations = 0;
    bool m_isHeld = false;
    /// What readers see.
    std::atomic<uint64_t> m_last{0};
    std::atomic<uint64_t> m_begun{0}; ///< m_last, or one more while a value is being written
    std::atomic<uint64_t> m_seenCleared{0};
    std::atomic<uint64_t> m_seenTruncations{0};
    std::atomic<uint64_t> m_generation{0};
};

} // namespace inspector
