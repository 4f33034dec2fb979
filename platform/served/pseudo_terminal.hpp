#pragma once

#include <string>
#include <utility>

namespace striate::served {

/// A pseudo-terminal whose other end anybody may open.
class PseudoTerminal {
 public:
  /// @throws std::runtime_error when none is to be had.
  PseudoTerminal();
  /// Hands the master's end over; whoever takes it closes it.
  [[nodiscard]] int release_master() { return master_.release(); }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  /// Closes what it holds.
  class Descriptor {
   public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor();
    Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
      std::swap(number_, other.number_);
      return *this;
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int get() const { return number_; }
    [[nodiscard]] int release() { return std::exchange(number_, -1); }

   private:
    int number_;
  };
  Descriptor master_;
  Descriptor slave_;
  std::string name_;
};

}  // namespace striate::served
