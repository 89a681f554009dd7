#include "samples/cli/json_writer.h"

#include <cmath>

#include "samples/cli/numbers.h"

namespace palpate::cli {

JsonWriter& JsonWriter::key(std::string_view name) {
  begin_value();
  write_text(name);
  out_ << ':';
  after_key_ = true;
  return *this;
}

JsonWriter& JsonWriter::close() {
  out_ << levels_.back().closing;
  levels_.pop_back();
  return *this;
}

JsonWriter& JsonWriter::value(double number) {
  begin_value();
  out_ << (std::isfinite(number) ? exact_text(number) : "null");
  return *this;
}

JsonWriter& JsonWriter::value(bool truth) {
  begin_value();
  out_ << (truth ? "true" : "false");
  return *this;
}

JsonWriter& JsonWriter::null() {
  begin_value();
  out_ << "null";
  return *this;
}

JsonWriter& JsonWriter::value(std::string_view text) {
  begin_value();
  write_text(text);
  return *this;
}

JsonWriter& JsonWriter::value(std::span<const double> numbers) {
  open_array();
  for (const double number : numbers) value(number);
  return close();
}

JsonWriter& JsonWriter::open(char opening, char closing) {
  begin_value();
  out_ << opening;
  levels_.push_back({closing});
  return *this;
}

// Writes the comma between this value and the one before it.
void JsonWriter::begin_value() {
  if (!after_key_ && !levels_.empty()) {
    if (!levels_.back().empty) out_ << ',';
    levels_.back().empty = false;
  }
  after_key_ = false;
}

void JsonWriter::write_text(std::string_view text) {
  constexpr char kHex[] = "0123456789abcdef";
  out_ << '"';
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out_ << '\\' << c;
    } else if (code < 0x20) {
      out_ << "\\u00" << kHex[code >> 4] << kHex[code & 15];
    } else {
      out_ << c;
    }
  }
  out_ << '"';
}

}  // namespace palpate::cli
