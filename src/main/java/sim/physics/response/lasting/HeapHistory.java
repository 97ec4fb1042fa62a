// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;

/** What is known of the last solutions of heaps, by their first bodies. */
final class HeapHistory implements Serializable {
    private static final long serialVersionUID = 1L;

    private Extrapolation[] extrapolations = {};
    private HeapForecast[] forecasts = {};

    HeapHistory() {
        // grows with the heaps
    }

    HeapForecast forecast(int first) {
        if (first >= forecasts.length) {
            forecasts = Arrays.copyOf(forecasts, Math.max(2 * forecasts.length, first + 1));
        }
        forecasts[first] = forecasts[first] == null ? new HeapForecast() : forecasts[first];
        return forecasts[first];
    }

    Extrapolation extrapolation(int first) {
        if (first >= extrapolations.length) {
            extrapolations = Arrays.copyOf(extrapolations, Math.max(2 * extrapolations.length, first + 1));
        }
        extrapolations[first] = extrapolations[first] == null ? new Extrapolation() : extrapolations[first];
        return extrapolations[first];
    }
}
