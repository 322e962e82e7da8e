// SPDX-License-Identifier: LGPL-2.1-or-later
// Draws the charts of a report with plotly.js, which the page carries compressed, in the colours of the page.
"use strict";
(() => {
  const color = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

  async function loadLibrary(packed) {
    const bytes = Uint8Array.from(atob(packed.textContent.trim()), c => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    const script = document.createElement("script");
    script.textContent = await new Response(stream).text();
    document.head.appendChild(script);
  }

  function axis(given) {
    return { gridcolor: color("--line"), zerolinecolor: color("--line"), linecolor: color("--soft"), automargin: true,
      ticks: "outside", tickcolor: color("--line"), ...given, title: { text: given.title, standoff: 8 } };
  }

  function layout(chart) {
    const narrow = window.innerWidth < 600;
    return { paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)", margin: { l: 50, r: 12, t: 30, b: 40 },
      modebar: { bgcolor: "rgba(0,0,0,0)", color: color("--soft"), activecolor: color("--accent") },
      font: { color: color("--ink"), size: narrow ? 11 : 12 }, hovermode: chart.hover || "x unified",
      hoverlabel: { bgcolor: color("--paper"), bordercolor: color("--line"), font: { color: color("--ink") } },
      legend: chart.side && !narrow ? { x: 1.02, y: 1, font: { size: 11 } } : { orientation: "h", y: -0.25, font: { size: 11 } },
      showlegend: chart.traces.length > 1, xaxis: axis(chart.x), yaxis: axis(chart.y) };
  }

  function draw(data) {
    // INK stands for the colour of the text.
    const read = () => JSON.parse(data.textContent.replaceAll('"INK"', JSON.stringify(color("--ink"))));
    const charts = read();
    const config = { displaylogo: false, responsive: true, modeBarButtonsToRemove: ["select2d", "lasso2d"],
      toImageButtonOptions: { format: "svg" } };
    const times = [];
    charts.forEach((chart, i) => {
      const place = document.getElementById("chart" + i);
      Plotly.newPlot(place, chart.traces, layout(chart), config);
      if (chart.kind === "time")
        times.push(place);
    });
    // Zooming in time zooms all diagrams over time.
    let busy = false;
    times.forEach(place => place.on("plotly_relayout", event => {
      const whole = event["xaxis.autorange"];
      if (busy || (event["xaxis.range[0]"] === undefined && !whole))
        return;
      busy = true;
      const range = whole ? { "xaxis.autorange": true, "yaxis.autorange": true }
        : { "xaxis.range": [event["xaxis.range[0]"], event["xaxis.range[1]"]] };
      Promise.all(times.filter(other => other !== place).map(other => Plotly.relayout(other, range)))
        .finally(() => { busy = false; });
    }));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change",
      () => read().forEach((chart, i) => Plotly.react("chart" + i, chart.traces, layout(chart), config)));
    document.body.dataset.charts = charts.length; // says to a test that all are there
  }

  function makeSortable(table) {
    table.querySelectorAll("thead th").forEach((head, column) => head.addEventListener("click", () => {
      const down = head.dataset.order === "↑";
      table.querySelectorAll("th").forEach(other => delete other.dataset.order);
      head.dataset.order = down ? "↓" : "↑";
      const key = row => row.cells[column].dataset.key ?? row.cells[column].textContent;
      const compare = (a, b) => { // what is no number comes last
        const [x, y] = [parseFloat(key(a)), parseFloat(key(b))];
        return isNaN(x) || isNaN(y) ? (isNaN(x) && isNaN(y) ? key(a).localeCompare(key(b)) : isNaN(x) - isNaN(y)) : x - y;
      };
      [...table.tBodies[0].rows].sort((a, b) => (down ? -1 : 1) * compare(a, b)).forEach(row => table.tBodies[0].append(row));
    }));
  }

  document.querySelectorAll("table.sortable").forEach(makeSortable);
  const packed = document.getElementById("plotly"), data = document.getElementById("chart-data");
  if (packed && data)
    loadLibrary(packed).then(() => draw(data)).catch(error => {
      document.querySelector(".charts").textContent = "This browser cannot draw the charts: " + error;
    });
})();
