#include <algorithm>
#include <cstring>
#include <thread>

#include "tests/capi/devices.h"
#include "tests/device/hid/mock_bus.h"
#include "tests/device/hid/mock_ohhp.h"

// A scene and a device on the bus, through the public interface alone.
namespace palpate::test {
namespace {

constexpr const char* kUri = "hid:1209:0001:SN42";
constexpr double kPushed = -0.010;  // m: where the hand wants to be, in the floor

// Patiently: on a machine with much else to do, samples come late again and again, and each time force ends.
template <class Condition>
bool wait_until(Condition&& condition) {
  for (int i = 0; i < 120'000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return condition();
}

// A cube in the hand, five millimetres above a floor.
class HidScene : public testing::Test {
 protected:
  void SetUp() override {
    plug();
    device_ = std::make_unique<TestDevice>(kUri);
    scene_.add(cube_.handle, PLP_BODY_STATIC, at(0.0, -0.105, 0.0));
    scene_.add(cube_.handle, PLP_BODY_TOOL, at(0.0, 0.0, 0.0));
    plp_scene_set_stiffness(scene_.handle, 200.0);
    const plp_device_mapping mapping = device_mapping();
    ASSERT_EQ(plp_scene_set_device(scene_.handle, device_->handle, &mapping), PLP_OK) << plp_last_error();
    ASSERT_EQ(plp_device_arm(device_->handle), PLP_OK);
    ASSERT_EQ(plp_scene_start(scene_.handle, nullptr), PLP_OK) << plp_last_error();
  }

  void plug() {
    mock_ = std::make_shared<MockOhhp>();
    mock_->change([](hid_device::HapticDevice& device) { device.mass().hold_at({0.0, kPushed, 0.0}); });
    mock_->start();
    number_ = bus_.plug(mock_);
  }

  bool wait_for(plp_condition condition) {
    return wait_until([&] { return device_->state().condition == condition; });
  }

  // The floor bears the hand.
  bool is_borne() {
    return wait_until([&] {
      const plp_device_state state = device_->state();
      return state.safety == PLP_SAFETY_ARMED && state.applied.force[1] > 0.3 &&
             mock_->log().back().force > 0.3 && state.pose.position[1] > kPushed + 0.002;
    });
  }

  void TearDown() override { plp_scene_stop(scene_.handle); }

  MockBus bus_;
  std::shared_ptr<MockOhhp> mock_;
  int number_ = -1;
  TestModel cube_{box(0.05f, 0.05f, 0.05f)};
  std::unique_ptr<TestDevice> device_;
  TestScene scene_{0.01};
};

TEST_F(HidScene, TheHandFeelsTheFloor) {
  EXPECT_TRUE(is_borne());
  const plp_device_info info = device_->info();
  EXPECT_STREQ(info.uri, kUri);
  EXPECT_EQ(info.actuated, 63u);
  EXPECT_EQ(info.max_force, 5.0);
  EXPECT_EQ(info.condition, PLP_CONDITION_READY);
}

TEST_F(HidScene, PulledOutAndPluggedInAgainTheFloorIsBack) {
  ASSERT_TRUE(is_borne());
  bus_.unplug(number_);
  ASSERT_TRUE(wait_for(PLP_CONDITION_LOST));
  const plp_device_state lost = device_->state();
  EXPECT_EQ(lost.safety, PLP_SAFETY_FAULT);
  EXPECT_EQ(lost.applied.force[1], 0.0);
  EXPECT_STRNE(device_->info().status, "");
  plug();
  EXPECT_TRUE(is_borne());
  EXPECT_EQ(device_->state().condition, PLP_CONDITION_READY);
}

TEST_F(HidScene, LostSamplesAreTold) {
  ASSERT_TRUE(is_borne());
  EXPECT_EQ(device_->state().lost, 0u);
  mock_->swallow(3);
  EXPECT_TRUE(wait_until([&] { return device_->state().lost == 3; }));
}

TEST_F(HidScene, IsListedAndMissingOnesAreToldFromIt) {
  std::size_t count = 0;
  ASSERT_EQ(plp_device_list(nullptr, 0, &count), PLP_OK);
  std::vector<plp_device_info> infos(count);
  for (plp_device_info& info : infos) plp_device_info_init(&info, sizeof info);
  ASSERT_EQ(plp_device_list(infos.data(), infos.size(), &count), PLP_OK);
  EXPECT_TRUE(
      std::any_of(infos.begin(), infos.end(), [](const auto& info) { return !std::strcmp(info.uri, kUri); }));
  plp_device other = nullptr;
  EXPECT_EQ(plp_device_open("hid:1209:0002", &other), PLP_ERROR_DEVICE);
  EXPECT_NE(std::string(plp_last_error()).find("no device \"hid:1209:0002\""), std::string::npos);
  EXPECT_EQ(plp_device_open(kUri, &other), PLP_ERROR_DEVICE);
  EXPECT_NE(std::string(plp_last_error()).find("open already"), std::string::npos);
}

}  // namespace
}  // namespace palpate::test
