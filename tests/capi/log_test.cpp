#include <string>

#include "tests/capi/shapes.h"

namespace palpate::test {
namespace {

struct Message {
  plp_log_level level;
  std::string text;
};

void keep(plp_log_level level, const char* message, void* user) {
  static_cast<std::vector<Message>*>(user)->push_back({level, message});
}

class LogTest : public testing::Test {
 protected:
  void TearDown() override { plp_set_log_callback(nullptr, nullptr); }

  std::vector<Message> messages_;
};

TEST_F(LogTest, ModelsAreAnnounced) {
  plp_set_log_callback(keep, &messages_);
  const TestModel model(box(1, 1, 1));
  ASSERT_EQ(messages_.size(), 1u);
  EXPECT_EQ(messages_[0].level, PLP_LOG_INFO);
  EXPECT_NE(messages_[0].text.find("12 triangles"), std::string::npos) << messages_[0].text;
}

TEST_F(LogTest, NotesAreWarnings) {
  plp_set_log_callback(keep, &messages_);
  Shape shape = box(1, 1, 1);
  shape.triangles.push_back({0, 0, 1});
  const TestModel model(shape);
  ASSERT_GE(messages_.size(), 2u);
  EXPECT_EQ(messages_[0].level, PLP_LOG_WARNING);
  EXPECT_NE(messages_[0].text.find(plp_model_note(model.handle, 0)), std::string::npos);
}

TEST_F(LogTest, RemovedReceiverHearsNothing) {
  plp_set_log_callback(keep, &messages_);
  plp_set_log_callback(nullptr, nullptr);
  const TestModel model(box(1, 1, 1));
  EXPECT_TRUE(messages_.empty());
}

TEST_F(LogTest, NewReceiverReplacesTheOld) {
  std::vector<Message> newer;
  plp_set_log_callback(keep, &messages_);
  plp_set_log_callback(keep, &newer);
  const TestModel model(box(1, 1, 1));
  EXPECT_TRUE(messages_.empty());
  EXPECT_EQ(newer.size(), 1u);
  plp_set_log_callback(nullptr, nullptr);
}

TEST_F(LogTest, ExceptionOfAReceiverStaysOutside) {
  plp_set_log_callback([](plp_log_level, const char*, void*) { throw 42; }, nullptr);
  const TestModel model(box(1, 1, 1));
  EXPECT_NE(model.handle, nullptr);
}

}  // namespace
}  // namespace palpate::test
