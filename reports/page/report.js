// Replaces the static drawing of each figure by an interactive one when it comes near the screen.
(function () {
  'use strict';
  if (!window.Plotly) return;

  const fonts = { family: 'system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif', size: 12.5, color: '#22303c' };

  function draw(frame) {
    const box = frame.querySelector('.plot');
    frame.classList.add('interactive');
    const figure = JSON.parse(box.nextElementSibling.textContent);
    const entries = figure.data.filter((trace) => trace.showlegend).length;
    const columns = box.clientWidth > 620 ? 2 : 1;
    const legend = 20 * Math.ceil(entries / columns) + 8;
    const height = 350 + legend;
    box.style.height = height + 'px';
    Object.assign(figure.layout, {
      height: height,
      font: fonts,
      margin: { l: 62, r: 16, t: 30, b: 58 + legend },
      hovermode: 'closest',
      hoverlabel: { namelength: -1 },
      plot_bgcolor: '#ffffff',
      paper_bgcolor: '#ffffff',
      legend: { orientation: 'h', x: 0, xanchor: 'left', y: 0, yref: 'container', yanchor: 'bottom',
                entrywidthmode: 'fraction', entrywidth: 0.98 / columns, font: { size: 12 } },
    });
    window.Plotly.newPlot(box, figure.data, figure.layout,
      { responsive: true, displaylogo: false, displayModeBar: 'hover', modeBarButtonsToRemove: ['select2d', 'lasso2d'] });
  }

  const frames = document.querySelectorAll('figure.drawing');
  const observer = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      if (!entry.isIntersecting) continue;
      observer.unobserve(entry.target);
      draw(entry.target);
    }
  }, { rootMargin: '400px' });
  frames.forEach((frame) => observer.observe(frame));

  window.addEventListener('beforeprint', () => {
    document.querySelectorAll('details').forEach((box) => { box.open = true; });
  });
})();
