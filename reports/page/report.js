// Turns the field pictures of each run into a player, and the static drawing of each figure into an interactive
// one when it comes near the screen. Without this script, and in print, all pictures and drawings are shown.
(function () {
  'use strict';

  function element(name, properties) {
    return Object.assign(document.createElement(name), properties);
  }

  function play(player) {
    const frames = Array.from(player.children);
    if (frames.length < 2) return;
    const previous = element('button', { type: 'button', textContent: '\u25c0 previous' });
    const next = element('button', { type: 'button', textContent: 'next \u25b6' });
    const slider = element('input', { type: 'range', min: 0, max: frames.length - 1, step: 1, value: 0 });
    const place = element('output');
    slider.setAttribute('aria-label', 'instant');
    const controls = element('div', { className: 'controls' });
    controls.append(previous, slider, next, place);
    player.before(controls);
    player.classList.add('playing');

    function show(index) {
      frames.forEach((frame, k) => frame.classList.toggle('current', k === index));
      slider.value = index;
      previous.disabled = index === 0;
      next.disabled = index === frames.length - 1;
      place.textContent = frames[index].dataset.instant + ' (' + (index + 1) + ' of ' + frames.length + ')';
      slider.setAttribute('aria-valuetext', frames[index].dataset.instant);
    }
    previous.addEventListener('click', () => show(Number(slider.value) - 1));
    next.addEventListener('click', () => show(Number(slider.value) + 1));
    slider.addEventListener('input', () => show(Number(slider.value)));
    show(0);
  }
  document.querySelectorAll('.player').forEach(play);

  window.addEventListener('beforeprint', () => {
    document.querySelectorAll('details:not(.source)').forEach((box) => { box.open = true; });
  });

  if (!window.Plotly) return;

  const fonts = { family: 'system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif', size: 12.5, color: '#22303c' };

  // Breaks a text between words, where a line would have more letters.
  function wrapped(text, letters) {
    const lines = [''];
    for (const word of text.split(' ')) {
      const longer = (lines[lines.length - 1] + ' ' + word).trim();
      if (longer.length > letters && lines[lines.length - 1]) lines.push(word);
      else lines[lines.length - 1] = longer;
    }
    return lines.join('<br>');
  }

  function draw(frame) {
    const box = frame.querySelector('.plot');
    frame.classList.add('interactive');
    const figure = JSON.parse(box.nextElementSibling.textContent);
    const entries = figure.data.filter((trace) => trace.showlegend);
    const longest = Math.max(0, ...entries.map((trace) => trace.name.length));
    const letters = (columns) => Math.floor((box.clientWidth / columns - 55) / 6.5);  // of a legend's line
    const columns = longest <= letters(2) ? 2 : 1;
    let lines = 0;
    for (const trace of entries) {
      trace.name = wrapped(trace.name, letters(columns));
      lines += trace.name.split('<br>').length;
    }
    const legend = 20 * Math.ceil(lines / columns) + 8;
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
      legend: { orientation: 'h', x: 0, xref: 'container', xanchor: 'left', y: 0, yref: 'container', yanchor: 'bottom',
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
})();
