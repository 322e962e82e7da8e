// SPDX-License-Identifier: LGPL-2.1-or-later
#include "schema.h"

#include "sections.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace ricochet
{
namespace
{
using Json = nlohmann::ordered_json;

std::string limit_name(const Limit limit)
{
  switch (limit)
  {
    case Limit::any:
      return "any";
    case Limit::not_negative:
      return "not negative";
    case Limit::positive:
      return "positive";
    case Limit::fraction:
      return "0 to 1";
  }
  return "";
}

void describe_quantity(const QuantityPattern &pattern, Json &json)
{
  const bool is_tuple = pattern.components().size() > 1;
  json["type"]        = pattern.is_list() ? "quantity list" : is_tuple ? "quantities" : "quantity";
  const std::string dimension = dimension_name(pattern.dimension());
  json["dimension"]           = dimension.substr(dimension.find(' ') + 1); // without its article
  json["units"]               = units_of(pattern.dimension());
  json["limit"]               = limit_name(pattern.limit());
  if (is_tuple)
    json["components"] = pattern.components();
}

void describe_pattern(const EntryPattern &pattern, Json &json)
{
  if (const auto *const quantity = dynamic_cast<const QuantityPattern *>(&pattern))
    describe_quantity(*quantity, json);
  else if (const auto *const choice = dynamic_cast<const ChoicePattern *>(&pattern))
  {
    json["type"] =
        choice->choices() == std::vector<std::string>{"true", "false"} ? "flag" : "choice";
    json["values"] = choice->choices();
  }
  else
    json["type"] = "text";
  json["expected"] = pattern.expected();
}

Json names_of_entries(const Entries &entries)
{
  Json names = Json::array();
  for (const Entry *const entry : entries)
    names.push_back(entry->name);
  return names;
}

Json describe_choice(const Choice &choice)
{
  Json rule{{"one_of", Json::array()}};
  for (const Entries &option : choice.options)
    rule["one_of"].push_back(names_of_entries(option));
  if (choice.condition.entry != nullptr)
    rule["if"] = {{"entry", choice.condition.entry->name}, {"values", choice.condition.words}};
  return rule;
}
} // namespace

Json describe_section(const Section &section, const std::string &file)
{
  const bool repeats =
      plate_number(section.name()) > 0 || section.name().rfind(material_prefix, 0) == 0;
  return {{"file", file},
          {"name", section.name()},
          {"meaning", section.documentation()},
          {"repeats", repeats}};
}

Json describe_entry(const Section &section, const Entry &entry, const std::string &file)
{
  Json json{{"file", file},
            {"section", section.name()},
            {"name", entry.name},
            {"meaning", entry.documentation}};
  describe_pattern(*entry.pattern, json);
  json["default"]  = entry.default_value.empty() ? Json() : Json(entry.default_value);
  json["example"]  = entry.example;
  json["required"] = entry.is_required;
  json["rules"]    = Json::array();
  for (const Choice *const choice : section.choices_with(entry))
    json["rules"].push_back(describe_choice(*choice));
  return json;
}
} // namespace ricochet
