// SPDX-License-Identifier: LGPL-2.1-or-later
#include "law_entries.h"
#include "ricochet/contact/contact_search.h"
#include "ricochet/contact/friction_laws.h"
#include "sections.h"

namespace ricochet
{
namespace
{
void add_friction_entries(Section &in, ContactParameters &contact)
{
  add_law(in, "Friction law", contact.friction, FrictionLaws(), "exponential",
          "Friction coefficient over the sliding speed");
  in.with_default("Regularisation speed",
                  quantity(contact.regularisation_speed, Dimension::speed, Limit::positive),
                  "5 m/s", "Sliding speed below which the friction falls linearly to zero");
}

void add_shank_entries(Section &in, ContactParameters &contact)
{
  in.with_default("Shank resistance",
                  quantity(contact.shank_resistance, Dimension::stress, Limit::not_negative),
                  "500 MPa", "Pressure of the plate on the shank, for its friction only");
  in.with_default("Shank contact fraction",
                  quantity(contact.shank_contact_fraction, Dimension::number, Limit::fraction),
                  "0.4", "Share of the shank that touches the plate; 0 switches its friction off");
}

void add_debris_entries(Section &in, ContactParameters &contact)
{
  in.with_default("Debris stiffness factor",
                  quantity(contact.debris_factor, Dimension::number, Limit::not_negative), "1",
                  "Repulsion of separated points, in units of the short-range stiffness; 0 "
                  "switches it off");
  const Entry &friction = in.with_default(
      "Debris friction factor",
      quantity(contact.debris_friction, Dimension::number, Limit::not_negative), "0",
      "Friction between plates and in debris, in units of the projectile's coefficient; 0 "
      "switches it off");
  in.check(
      [&contact, &friction]
      {
        if (contact.debris_friction > 0. && contact.debris_factor == 0.)
          friction.fail("Separated points that do not repel have nothing to rub against.",
                        "Set 'Debris stiffness factor' above 0 (1 is usual), or this one to 0.");
      });
}
} // namespace

Section contact_section(ContactParameters &contact)
{
  Section in("Contact",
             "Contact of the projectile with the plates, and of fragments with each other.");
  in.with_default("Stiffness factor",
                  quantity(contact.stiffness_factor, Dimension::number, Limit::positive), "1",
                  "Penalty stiffness per point, in Young's moduli times grid spacing");
  add_friction_entries(in, contact);
  add_shank_entries(in, contact);
  add_debris_entries(in, contact);
  in.with_default("Search method", word(contact.search, contact_search_names()), "linked cells",
                  "How separated points that touch are found; the result is the same");
  return in;
}
} // namespace ricochet
