using System;
using System.IO;
using System.Text;

namespace Palpate.Tests
{
    /// <summary>What the tests are given, and shapes.</summary>
    internal static class Samples
    {
        internal static readonly float[] BoxPositions =
        {
            -0.5f, -0.5f, -0.5f, 0.5f, -0.5f, -0.5f, -0.5f, 0.5f, -0.5f, 0.5f, 0.5f, -0.5f,
            -0.5f, -0.5f, 0.5f, 0.5f, -0.5f, 0.5f, -0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f
        };

        internal static readonly int[] BoxIndices =
        {
            0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5
        };

        /// <summary>Edge length 1, centred.</summary>
        internal static Model Box() => Model.FromTriangles(BoxPositions, BoxIndices);

        internal static string ModelPath(string name) => Path.Combine(Given("PALPATE_TEST_MODELS"), name);

        internal static string ReferencePath => Given("PALPATE_TEST_REFERENCE");

        internal static string LayoutPath => Given("PALPATE_TEST_LAYOUT");

        internal static string TemporaryPath(string name) => Path.Combine(Path.GetTempPath(), "palpate_" + Guid.NewGuid() + name);

        /// <summary>A glTF file of one triangle, with anything replaced.</summary>
        internal static byte[] Gltf(string from = "", string to = "")
        {
            const string Text = @"{""asset"": {""version"": ""2.0""}, ""scene"": 0, ""scenes"": [{""nodes"": [0]}],
                ""nodes"": [{""mesh"": 0}], ""meshes"": [{""primitives"": [{""attributes"": {""POSITION"": 0}}]}],
                ""accessors"": [{""bufferView"": 0, ""componentType"": 5126, ""count"": 3, ""type"": ""VEC3"",
                ""min"": [0, 0, 0], ""max"": [1, 1, 0]}], ""bufferViews"": [{""buffer"": 0, ""byteLength"": 36}],
                ""buffers"": [{""byteLength"": 36, ""uri"":
                ""data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA""}]}";
            if (from != "" && Text.IndexOf(from, StringComparison.Ordinal) < 0)
            {
                throw new ArgumentException(from + " is not there");
            }
            return Encoding.UTF8.GetBytes(from == "" ? Text : Text.Replace(from, to));
        }

        private static string Given(string name) =>
            Environment.GetEnvironmentVariable(name) ?? throw new InvalidOperationException(name + " is not set");
    }
}
