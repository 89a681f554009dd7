using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;

namespace Palpate.Tests
{
    /// <summary>One scene told in the space of an engine: what vector_lines.py wrote.</summary>
    internal sealed class SpaceVectors
    {
        private readonly Dictionary<string, double[]> numbers = new Dictionary<string, double[]>();

        internal string Name { get; private set; }

        internal Space Space
        {
            get
            {
                int[] axes = Array.ConvertAll(numbers["axes"], axis => (int)axis);
                return new Space(axes[0], axes[1], axes[2], Number("metres_per_unit"));
            }
        }

        internal double Number(string word) => numbers[word][0];

        internal double[] Vertices(string part) => numbers[part + ".vertices"];

        internal int[] Triangles(string part) => Array.ConvertAll(numbers[part + ".triangles"], index => (int)index);

        internal Vector3d Vector(string word) => new Vector3d(numbers[word][0], numbers[word][1], numbers[word][2]);

        internal Pose Pose(string part)
        {
            double[] turn = numbers[part + ".orientation"];
            return new Pose(Vector(part + ".position"), new Quaterniond(turn[0], turn[1], turn[2], turn[3]));
        }

        internal static List<SpaceVectors> Read()
        {
            var spaces = new List<SpaceVectors>();
            foreach (string line in File.ReadAllLines(Environment.GetEnvironmentVariable("PALPATE_TEST_VECTORS")))
            {
                string[] words = line.Split(' ');
                if (words[0] == "name")
                {
                    spaces.Add(new SpaceVectors { Name = line.Substring(words[0].Length + 1) });
                    continue;
                }
                var values = new double[words.Length - 1];
                for (int i = 0; i < values.Length; ++i)
                {
                    values[i] = double.Parse(words[i + 1], CultureInfo.InvariantCulture);
                }
                spaces[spaces.Count - 1].numbers.Add(words[0], values);
            }
            return spaces;
        }
    }
}
