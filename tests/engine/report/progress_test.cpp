// SPDX-License-Identifier: Apache-2.0
#include "engine/report/progress.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <thread>

namespace ilot {
namespace {

struct Recorded {
  double time = 100;
  std::string console;
  std::vector<nlohmann::json> events;

  ProgressOptions options(Verbosity verbosity = Verbosity::normal, bool live = false) {
    ProgressOptions o;
    o.verbosity = verbosity;
    o.live = live;
    o.console = [this](std::string_view text) { console += text; };
    o.events = [this](std::string_view text) {
      ASSERT_EQ(text.back(), '\n');
      events.push_back(nlohmann::json::parse(text));
    };
    o.clock = [this] { return time; };
    return o;
  }
  std::vector<std::string> names() const {
    std::vector<std::string> list;
    for (const auto& e : events) list.push_back(e["event"]);
    return list;
  }
};

TEST(Progress, EventsOfARun) {
  Recorded r;
  Progress p(r.options());
  p.run_start("2 inputs");
  p.input_ok("a.las", 1000);
  p.input_skipped("b.las", "0 points");
  p.begin_stage("index", 1000);
  p.advance(250);
  r.time += 10;
  p.tick();
  p.unit_done("block-7", 400, 1, 2);
  p.unit_skipped("block-8", "no plane");
  p.advance(750);
  p.begin_stage("normals", 0);
  p.run_done("done");
  EXPECT_EQ(r.names(),
            (std::vector<std::string>{"run_start", "input_ok", "input_skipped", "stage_start", "heartbeat", "unit_done",
                                      "unit_skipped", "stage_done", "stage_start", "stage_done", "run_done"}));
  const nlohmann::json& beat = r.events[4];
  EXPECT_EQ(beat["stage"], "index");
  EXPECT_EQ(beat["done"], 250);
  EXPECT_EQ(beat["total"], 1000);
  EXPECT_EQ(beat["points_per_s"], 25);
  EXPECT_EQ(beat["eta_s"], 30);
  EXPECT_EQ(beat["t"], 10);
  EXPECT_GT(beat["rss_bytes"], 0);
  EXPECT_EQ(r.events[2]["msg"], "0 points");
  EXPECT_EQ(r.events[7]["points"], 1000);
  EXPECT_EQ(r.events[7]["points_per_s"], 100);
}

TEST(Progress, KeepsWhatEachStageTook) {
  Recorded r;
  Progress p(r.options());
  p.begin_stage("index", 10);
  p.advance(10);
  r.time += 2;
  p.end_stage();
  p.end_stage();
  ASSERT_EQ(p.stages().size(), 1u);
  EXPECT_EQ(p.stages()[0].name, "index");
  EXPECT_EQ(p.stages()[0].seconds, 2);
  EXPECT_EQ(p.stages()[0].points, 10u);
  EXPECT_GE(p.stages()[0].cpu_seconds, 0);
}

TEST(Progress, APlainLineEveryTenSeconds) {
  Recorded r;
  Progress p(r.options());
  p.begin_stage("index", 4000000);
  p.advance(1000000);
  for (int second = 0; second < 25; ++second) {
    r.time += 1;
    p.tick();
  }
  EXPECT_EQ(r.console,
            "index  25.0 %, 1,000,000 points, 100,000 points/s, 0:30 left\n"
            "index  25.0 %, 1,000,000 points, 50,000 points/s, 1:00 left\n");
}

TEST(Progress, OneLiveLineThatIsWipedBeforeOtherText) {
  Recorded r;
  Progress p(r.options(Verbosity::normal, true));
  p.begin_stage("index", 100);
  p.advance(50);
  r.time += 1;
  p.tick();
  p.tick();
  EXPECT_EQ(r.console, "\r\x1b[Kindex  50.0 %, 50 points, 50 points/s, 0:01 left");
  r.console.clear();
  p.warn("b.las: odd");
  EXPECT_EQ(r.console, "\r\x1b[Kilot: b.las: odd\n");
  r.console.clear();
  p.note("c.las: odd");
  EXPECT_EQ(r.console, "ilot: c.las: odd\n");
}

TEST(Progress, QuietKeepsOnlyWhatIsWrong) {
  Recorded r;
  Progress p(r.options(Verbosity::quiet, true));
  p.run_start("go");
  p.begin_stage("index", 100);
  r.time += 60;
  p.tick();
  p.note("chosen");
  p.run_done("done");
  EXPECT_EQ(r.console, "");
  p.input_skipped("b.las", "0 points");
  p.unit_skipped("u", "no plane");
  EXPECT_EQ(r.console, "ilot: b.las: skipped: 0 points\nilot: u: skipped: no plane\n");
}

TEST(Progress, UnitsOfOneReasonAreOneLine) {
  Recorded r;
  Progress p(r.options());
  p.units_skipped(std::vector<std::string>{"a", "b", "c", "d", "e"}, "footprints are", "fewer than 3 points");
  EXPECT_EQ(r.console, "ilot: 5 footprints are skipped: fewer than 3 points: a, b, c and 2 more\n");
  EXPECT_EQ(r.names(), (std::vector<std::string>(5, "unit_skipped")));
  EXPECT_EQ(r.events[4]["unit"], "e");
}

TEST(Progress, MorePointsThanAnnounced) {
  Recorded r;
  Progress p(r.options());
  p.begin_stage("index", 10);
  p.advance(20);
  r.time += 10;
  p.tick();
  EXPECT_EQ(r.console, "index 100.0 %, 20 points, 2 points/s\n");
  EXPECT_TRUE(r.events.back()["eta_s"].is_null());
}

TEST(Progress, NoRateOfNothingOrOfNoTime) {
  Recorded r;
  Progress p(r.options());
  p.begin_stage("index", 100);
  p.advance(100);
  r.time += 0.04;
  p.end_stage();
  p.begin_stage("normals", 0);
  r.time += 5;
  p.end_stage();
  p.begin_stage("planes", 100);
  p.advance(100);
  r.time += 0.5;
  p.end_stage();
  EXPECT_EQ(r.console,
            "index: 100 points in 0.0 s\n"
            "normals: 0 points in 5.0 s\n"
            "planes: 100 points in 0.5 s, 200 points/s\n");
}

TEST(Progress, APlanGivesOneBarOverAllStages) {
  Recorded r;
  Progress p(r.options());
  p.plan({{"index", 1}, {"normals", 2}, {"roofs", 6}, {"write", 1}});
  p.begin_stage("index", 100);
  p.advance(100);
  p.begin_stage("roofs", 3000, {13, "buildings"});  // passes over the normals
  p.advance(1500);
  r.time += 12;
  p.tick();
  EXPECT_EQ(r.console,
            "index: 100 points in 0.0 s\n"
            "[############--------]  60 %  roofs: 6 of 13 buildings, 0:08 left\n");
  r.console.clear();
  p.end_stage();
  EXPECT_EQ(r.console, "roofs: 13 buildings in 12.0 s\n");
}

TEST(Progress, TimeLeftFallsWhileWorkGoesOnEvenly) {
  Recorded r;
  Progress p(r.options(Verbosity::normal, true));
  p.plan({{"index", 1}, {"planes", 9}});
  int last = 1 << 20;
  for (const char* stage : {"index", "planes"}) {
    p.begin_stage(stage, 90);
    for (int step = 0; step < 90; ++step) {
      p.advance(1);
      r.time += stage[0] == 'i' ? 1 : 9;
      r.console.clear();
      p.tick();
      const std::size_t left = r.console.find(" left");
      if (left == std::string::npos) continue;
      const std::size_t begin = r.console.rfind(' ', left - 1) + 1, colon = r.console.find(':', begin);
      const int seconds = 60 * std::stoi(r.console.substr(begin)) + std::stoi(r.console.substr(colon + 1));
      EXPECT_LE(seconds, last);
      last = seconds;
    }
  }
  EXPECT_EQ(last, 0);
}

TEST(Progress, AnyBytesInNamesStayJson) {
  Recorded r;
  Progress p(r.options());
  p.input_skipped("\xff\"\n\x01", "r\\");
  EXPECT_EQ(r.events[0]["msg"], "r\\");
}

TEST(Progress, ManyThreads) {
  Recorded r;
  Progress p(r.options());
  p.begin_stage("index", 40000);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&p] {
      for (int i = 0; i < 10000; ++i) p.advance(1);
      p.tick();
      p.unit_done("u", 1, 1, 4);
    });
  }
  for (auto& thread : threads) thread.join();
  p.end_stage();
  EXPECT_EQ(p.stages()[0].points, 40000u);
}

TEST(Grouped, Thousands) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(123456), "123,456");
  EXPECT_EQ(grouped(18446744073709551615ull), "18,446,744,073,709,551,615");
}

}  // namespace
}  // namespace ilot
