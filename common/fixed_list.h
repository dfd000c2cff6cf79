#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <new>
#include <type_traits>

namespace hipmap {

/// A list of at most `capacity` values in the object itself.  Unlike std::array it initialises only
/// the values that it holds, so an empty list costs nothing.
template <typename Value, std::size_t capacity>
class FixedList {
    static_assert(std::is_trivially_destructible_v<Value>);

  public:
    FixedList() = default;
    FixedList(const FixedList&) = delete;
    FixedList& operator=(const FixedList&) = delete;

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    /// There must be room.
    void push(const Value& value)
    {
        assert(size_ < capacity);
        new (&places_[size_++].value) Value(value);
    }
    /// Removes the last value and returns it; the list must not be empty.
    Value pop()
    {
        assert(size_ > 0);
        return places_[--size_].value;
    }
    /// Removes all values but the first; the list must not be empty.
    void keep_first()
    {
        assert(size_ > 0);
        size_ = 1;
    }
    Value& operator[](std::size_t i)
    {
        assert(i < size_);
        return places_[i].value;
    }
    const Value& operator[](std::size_t i) const
    {
        assert(i < size_);
        return places_[i].value;
    }

  private:
    union Place {
        Place() {} // leaves the value out
        Value value;
    };
    std::array<Place, capacity> places_;
    std::size_t size_ = 0;
};

} // namespace hipmap
