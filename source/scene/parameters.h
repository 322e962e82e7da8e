// SPDX-License-Identifier: LGPL-2.1-or-later
// The entries of a parameter file held against their declarations: every name known, every value of
// the declared form, nothing missing. Held in a deal.II ParameterHandler.
#pragma once

#include "declarations.h"
#include "ricochet/scene/parameter_file.h"

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace ricochet
{
class Parameters
{
public:
  /**
   * Throws InputError that names file, line, value, what is expected and what to do: for an unknown
   * section or entry, a value that does not match its pattern, two options of one choice, and, in
   * one message, for all that is missing.
   */
  Parameters(const ParameterFile &file, std::vector<SectionDeclaration> sections);

  const std::vector<SectionDeclaration> &sections() const { return sections_; }

  /// Whether the file or an override sets the entry to a value (that is not empty).
  bool is_given(const std::string &section, const std::string &name) const;

  // The value or its default. The entry must be declared with a pattern of the kind read.
  // Quantities are in SI; one that is neither given nor has a default reads as 0.
  std::string text(const std::string &section, const std::string &name) const;
  bool flag(const std::string &section, const std::string &name) const;
  double quantity(const std::string &section, const std::string &name) const;
  std::vector<double> quantities(const std::string &section, const std::string &name) const;

  /// "prm/base.prm:12", or the file alone for an entry that is not given.
  std::string origin(const std::string &section, const std::string &name) const;

  /// Throws InputError about the value of an entry: "origin: Section/Name = 'value': what", remedy.
  [[noreturn]] void fail(const std::string &section, const std::string &name,
                         const std::string &what, const std::string &remedy) const;

private:
  const SectionDeclaration *find_section(const std::string &name) const;
  const EntryDeclaration *find_entry(const std::string &section, const std::string &name) const;
  const ParameterEntry *given(const std::string &section, const std::string &name) const;

  void check_sections(const ParameterFile &file) const;
  void check_value(const ParameterEntry &entry) const;
  void check_missing() const;

  bool applies(const Choice &choice, const std::string &section) const;
  /// Number of the option of which an entry is given, the number of options if there is none.
  std::size_t option_given(const Choice &choice, const std::string &section) const;

  [[noreturn]] void fail_unknown_entry(const ParameterEntry &entry) const;

  std::string path_;
  std::vector<SectionDeclaration> sections_;
  std::vector<ParameterEntry> given_; // those with a value
  dealii::ParameterHandler handler_;
};
} // namespace ricochet
