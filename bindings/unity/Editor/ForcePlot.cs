// SPDX-License-Identifier: MIT
using UnityEditor;
using UnityEngine;

namespace Palpate.Unity.Editor
{
    /// <summary>The newest values of one quantity over time.</summary>
    internal sealed class ForcePlot
    {
        private readonly float[] values;
        private readonly Vector3[] points;
        private int next;

        internal ForcePlot(int count)
        {
            values = new float[count];
            points = new Vector3[count];
        }

        internal float Largest
        {
            get
            {
                float largest = 0;
                foreach (float value in values)
                {
                    largest = Mathf.Max(largest, value);
                }
                return largest;
            }
        }

        internal void Add(float value)
        {
            values[next] = value;
            next = (next + 1) % values.Length;
        }

        /// <summary>From the oldest at the left to the newest at the right; the largest reaches the top.</summary>
        internal void Draw(Rect area, Color colour)
        {
            EditorGUI.DrawRect(area, new Color(0, 0, 0, 0.3f));
            float scale = area.height / Mathf.Max(Largest, 1e-6f);
            for (int i = 0; i < points.Length; ++i)
            {
                points[i].x = area.x + area.width * i / (points.Length - 1);
                points[i].y = area.y + area.height - scale * values[(next + i) % values.Length];
            }
            Handles.color = colour;
            Handles.DrawPolyLine(points);
        }
    }
}
