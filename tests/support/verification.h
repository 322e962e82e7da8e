// SPDX-License-Identifier: LGPL-2.1-or-later
// Rows of doc/verification.md. A test states there what is asked, under the number of the list, and
// what came out: each function below both checks that and, if RICOCHET_VERIFICATION names a folder,
// notes it in a file there, from which tests/verification/write_page.py makes the page. Number and
// requirement are written out at the call, so that the page can be held against the tests.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mpi.h>
#include <string>
#include <unistd.h>

namespace ricochet::tests
{
inline void note_verification(const std::string &number, const std::string &requirement,
                              const double measured, const char *relation, const double limit,
                              const double tolerance)
{
  const char *folder = std::getenv("RICOCHET_VERIFICATION");
  int rank           = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (folder == nullptr || rank != 0)
    return;
  const auto *test = testing::UnitTest::GetInstance()->current_test_info();
  std::filesystem::create_directories(folder);
  std::ofstream file(std::filesystem::path(folder) / (std::to_string(getpid()) + ".tsv"),
                     std::ios::app);
  file.precision(10);
  file << number << '\t' << requirement << '\t' << measured << '\t' << relation << '\t' << limit
       << '\t' << tolerance << '\t' << test->test_suite_name() << '.' << test->name() << '\n';
}

inline void verify_at_most(const std::string &number, const std::string &requirement,
                           const double measured, const double limit)
{
  note_verification(number, requirement, measured, "<=", limit, 0.);
  EXPECT_LE(measured, limit) << number << ": " << requirement;
}

/// For what must fail.
inline void verify_at_least(const std::string &number, const std::string &requirement,
                            const double measured, const double limit)
{
  note_verification(number, requirement, measured, ">=", limit, 0.);
  EXPECT_GE(measured, limit) << number << ": " << requirement;
}

inline void verify_near(const std::string &number, const std::string &requirement,
                        const double measured, const double expected, const double tolerance)
{
  note_verification(number, requirement, measured, "=", expected, tolerance);
  EXPECT_NEAR(measured, expected, tolerance) << number << ": " << requirement;
}
} // namespace ricochet::tests
