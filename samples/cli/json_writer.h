#pragma once

#include <concepts>
#include <ostream>
#include <span>
#include <string_view>
#include <vector>

namespace palpate::cli {

// Writes one JSON value, compact, to a stream. The caller closes what it opens.
class JsonWriter {
 public:
  explicit JsonWriter(std::ostream& out) : out_(out) {}

  JsonWriter& key(std::string_view name);  // inside an object, before each value
  JsonWriter& open_object() { return open('{', '}'); }
  JsonWriter& open_array() { return open('[', ']'); }
  JsonWriter& close();

  JsonWriter& value(
      double number);  // 17 significant digits, so that it is read back exactly; not finite: null
  JsonWriter& null();
  JsonWriter& value(bool truth);
  JsonWriter& value(std::string_view text);
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  JsonWriter& value(std::span<const double> numbers);
  JsonWriter& value(std::integral auto number) {
    begin_value();
    out_ << number;
    return *this;
  }

  // A key and its value.
  template <class Value>
  JsonWriter& field(std::string_view name, const Value& v) {
    return key(name).value(v);
  }

 private:
  struct Level {
    char closing;
    bool empty = true;
  };

  JsonWriter& open(char opening, char closing);
  void begin_value();
  void write_text(std::string_view text);

  std::ostream& out_;
  std::vector<Level> levels_;
  bool after_key_ = false;
};

}  // namespace palpate::cli
