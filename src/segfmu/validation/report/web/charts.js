"use strict";
// Charts over time; a line in each follows the time of the view.
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const DASHES = {x: "solid", y: "9px,3px", z: "3px,2px", run: "solid", plan: "2px,3px"};
  const GREY = "rgba(128,134,140,0.55)", BAND = "rgba(128,134,140,0.25)";
  const MOST_ARRIVALS = 40;
  const drawn = new Map();
  // the library takes texts for markup, and the names of users have none
  const plain = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;");

  const traces = (chart) => chart.curves.map((curve) => ({
    x: curve.x, y: curve.y, name: plain(curve.name), uid: curve.role, type: "scatter",
    mode: chart.kind === "points" ? "markers" : "lines", marker: {size: 5, opacity: 0.6},
    line: {
      width: curve.role === "plan" ? 1.6 : 2, dash: DASHES[curve.role],
      shape: chart.kind === "steps" ? "hv" : "linear",
    },
    fill: chart.kind === "steps" ? "tozeroy" : "none", fillcolor: "rgba(0,114,178,0.3)",
    hovertemplate: "%{y:.4~g} " + chart.unit,
  }));

  // from the least to the greatest value, limits included, with a rim
  const range = (chart, key, limits) => {
    let low = Infinity, high = -Infinity;
    for (const curve of chart.curves) {
      for (const value of curve[key]) [low, high] = [Math.min(low, value), Math.max(high, value)];
    }
    for (const limit of limits) {
      if (limit !== null) [low, high] = [Math.min(low, limit), Math.max(high, limit)];
    }
    const size = Math.max(Math.abs(low), Math.abs(high));
    // what does not change is not enlarged to noise
    const least = 1e-3 * size || 1;
    if (high - low < least) [low, high] = [low - least, high + least];
    const rim = 0.08 * (high - low);
    return [low - rim, high + rim];
  };

  // what is beyond the limits, and the arrivals at waypoints
  const shapes = (chart, ranges) => {
    const many = chart.arrivals.length > MOST_ARRIVALS;
    const found = (many ? [] : chart.arrivals).map((time) => ({
      type: "line", xref: "x", yref: "paper", x0: time, x1: time, y0: 0, y1: 1, layer: "below",
      line: {color: GREY, width: 1},
    }));
    const steps = chart.kind === "steps";
    const edges = steps ? ranges.x : ranges.y;
    chart.limits.forEach((limit, i) => {
      if (limit === null) return;
      const along = steps ? {xref: "x", yref: "paper", x0: limit, x1: edges[i], y0: 0, y1: 1}
        : {xref: "paper", yref: "y", x0: 0, x1: 1, y0: limit, y1: edges[i]};
      found.push({type: "rect", ...along, fillcolor: BAND, line: {width: 0}, layer: "below"});
    });
    return found;
  };

  const layout = (chart) => {
    const steps = chart.kind === "steps", timed = !chart.across;
    const ranges = {
      x: timed ? [0, chart.end] : range(chart, "x", steps ? chart.limits : []),
      y: range(chart, "y", steps ? [0] : chart.limits),
    };
    if (steps) ranges.y[0] = 0;
    return {
      margin: {l: 58, r: 12, t: 6, b: timed ? 30 : 44}, paper_bgcolor: "rgba(0,0,0,0)",
      plot_bgcolor: "rgba(0,0,0,0)", showlegend: false, dragmode: false,
      hovermode: chart.kind === "points" ? "closest" : "x unified",
      hoverlabel: {bgcolor: "#22282e", font: {color: "#ffffff", size: 13}},
      font: {family: "system-ui, sans-serif", size: 12}, shapes: shapes(chart, ranges),
      xaxis: {
        range: ranges.x, fixedrange: true, ticksuffix: timed ? " s" : "", showticksuffix: "last",
        zeroline: false, nticks: timed ? 7 : 4, tickangle: 0, exponentformat: "e", showexponent: "all",
        title: timed ? {} : {text: plain(chart.across), standoff: 6},
      },
      yaxis: {range: ranges.y, fixedrange: true, nticks: 6, zeroline: true, exponentformat: "e"},
    };
  };

  async function draw(place) {
    if (drawn.has(place)) return;
    const chart = data.charts[Number(place.dataset.chart)];
    drawn.set(place, chart);
    await Plotly.newPlot(place, traces(chart), layout(chart), {
      displayModeBar: false, responsive: true, doubleClick: false, showTips: false,
    });
    const cursor = document.createElement("div");
    cursor.className = "cursor";
    place.append(cursor);
  }

  // the page shows before the library starts
  async function start() {
    await Promise.race([
      new Promise((next) => requestAnimationFrame(() => setTimeout(next))),
      new Promise((next) => setTimeout(next, 1000)),
    ]);
    const library = document.createElement("script");
    library.textContent = document.getElementById("plotly").textContent;
    document.head.append(library);
    await drawAll();
  }

  // one after the other, so that the page stays alive
  async function drawAll() {
    for (const place of document.querySelectorAll(".chart")) {
      if (place.closest("details:not([open])")) continue;
      await draw(place);
      await new Promise((next) => setTimeout(next));
    }
    document.body.dataset.drawn = "yes";
  }

  document.addEventListener("toggle", (event) => {
    if (event.target.open && window.Plotly) event.target.querySelectorAll(".chart").forEach(draw);
  }, true);

  document.addEventListener("scenetime", (event) => {
    for (const [place, chart] of drawn) {
      const cursor = place.querySelector(".cursor"), axis = place._fullLayout?.xaxis;
      if (!cursor || !axis) continue;
      const shown = chart.scene === event.detail.scene && event.detail.time <= chart.end;
      cursor.style.display = shown ? "block" : "none";
      cursor.style.left = axis._offset + axis.l2p(event.detail.time) + "px";
    }
  });

  // on paper the drawings are scaled: there is no time to draw them again
  window.addEventListener("beforeprint", () => {
    for (const part of document.querySelectorAll(".chart .main-svg")) {
      part.setAttribute("viewBox", `0 0 ${part.getAttribute("width")} ${part.getAttribute("height")}`);
    }
  });
  window.addEventListener("afterprint", () => {
    for (const part of document.querySelectorAll(".chart .main-svg")) part.removeAttribute("viewBox");
  });
  start();
})();
